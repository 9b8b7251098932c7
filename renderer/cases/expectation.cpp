#include "cases/expectation.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/check.h"
#include "plan/frame_plan.h"

namespace timeshade {

namespace {

using glm::dvec2;
using glm::dvec3;

constexpr double nearestCaster = 1e-7;  // of the way to the light: less than any receiver's clearance

struct Corners {
    dvec3 open[3], close[3];
};

/// The case's scene in double precision, relative to the plan's origin.
class World {
  public:
    World(const ClosedFormCase& c, int samplesPerPixel, int mapSize) : mapSize_(mapSize) {
        FramePlanner planner(*c.scene);
        plan_ = planner.plan(c.request(samplesPerPixel, mapSize, 1));
        const MeshTopology& topology = *plan_.mesh->topology;
        for (const glm::u32vec3& t : topology.triangles) {
            Corners corners;
            for (int i = 0; i < 3; ++i) {
                corners.open[i] = plan_.mesh->positionsOpen[t[i]] - plan_.origin;
                corners.close[i] = plan_.mesh->positionsClose[t[i]] - plan_.origin;
            }
            triangles_.push_back(corners);
        }
    }

    std::size_t triangles() const { return triangles_.size(); }
    dvec3 origin() const { return plan_.origin; }
    dvec3 light(double u) const { return glm::mix(plan_.light.open.eye, plan_.light.close.eye, u); }

    /// Map coordinates in [0, 1]^2 and the depth along the light's axis.
    dvec3 project(const dvec3& point, double u) const {
        const ViewEnd& end = plan_.light.open;  // the axes are constant
        const dvec3 axis = glm::normalize(glm::cross(end.up, end.right));
        const dvec3 v = point - light(u);
        const double z = glm::dot(v, axis);
        const dvec3 w = v / z - end.corner;
        return {glm::dot(w, end.right) / glm::dot(end.right, end.right), glm::dot(w, end.up) / glm::dot(end.up, end.up),
                z};
    }
    /// The ray from the light through a point of the map; its depth along the axis is 1.
    dvec3 ray(const dvec2& map) const {
        return plan_.light.open.corner + plan_.light.open.right * map.x + plan_.light.open.up * map.y;
    }
    double texelWidth(double depth) const { return glm::length(plan_.light.open.right) / mapSize_ * depth; }
    double nearDistance() const { return static_cast<double>(plan_.light.block.nearDistance); }
    dvec2 centreOfTexel(const dvec3& p) const {
        return (glm::floor(dvec2(p) * double(mapSize_)) + 0.5) / double(mapSize_);
    }
    double texel() const { return 1.0 / mapSize_; }

    /// The s at which from + s * direction intersects a triangle at time u, if it does.
    std::optional<double> meeting(std::size_t triangle, double u, const dvec3& from, const dvec3& direction) const {
        const Corners& t = triangles_[triangle];
        dvec3 v[3];
        for (int i = 0; i < 3; ++i) v[i] = glm::mix(t.open[i], t.close[i], u) - from;
        const double e0 = glm::dot(direction, glm::cross(v[1], v[2])), e1 = glm::dot(direction, glm::cross(v[2], v[0])),
                     e2 = glm::dot(direction, glm::cross(v[0], v[1])), sum = e0 + e1 + e2;
        if (!((e0 >= 0 && e1 >= 0 && e2 >= 0) || (e0 <= 0 && e1 <= 0 && e2 <= 0)) || sum == 0.0) return std::nullopt;
        return glm::dot(v[0], glm::cross(v[1], v[2])) / sum;
    }

    /// The s at which from + s * direction intersects the plane of a triangle at time u.
    double planeDistance(std::size_t triangle, double u, const dvec3& from, const dvec3& direction) const {
        const Corners& t = triangles_[triangle];
        const dvec3 v0 = glm::mix(t.open[0], t.close[0], u), v1 = glm::mix(t.open[1], t.close[1], u),
                    v2 = glm::mix(t.open[2], t.close[2], u);
        const dvec3 normal = glm::cross(v1 - v0, v2 - v0);
        return glm::dot(v0 - from, normal) / glm::dot(direction, normal);
    }

  private:
    int mapSize_;
    FramePlan plan_;
    std::vector<Corners> triangles_;
};

/// Integrates numerically over positions on the receiver, times of the receiver and times of the casters.
class Model {
  public:
    Model(const ClosedFormCase& c, const SamplingTraits& traits, int strata, int mapSize)
        : case_(c), traits_(traits), strata_(strata), world_(c, strata, mapSize), biasTexels_(traits.biasTexels) {
        // Fewer steps for scenes of many triangles, to bound the run time.
        const bool crowd = world_.triangles() > 100;
        places_ = crowd ? 4 : 6;
        steps_ = crowd ? 12 : 48;
        if (traits.times == SamplingTraits::Times::RandomInStratum) steps_ = crowd ? 6 : 16;
    }

    Expectation result() {
        Expectation e;
        e.litOfStratum.assign(static_cast<std::size_t>(strata_), 0.0);
        seenOfStratum_.assign(static_cast<std::size_t>(strata_), 0);
        for (int k = 0; k < stepsInAll(); ++k) {
            if (!isSeen(k)) continue;
            ++seenOfStratum_[stratumOf(k)];
            ++stepsSeen_;
        }
        double ambiguous = 0.0;
        for (int i = 0; i < places_; ++i)
            for (int j = 0; j < places_; ++j)
                addPlace({(i + 0.5) / places_ - 0.5, (j + 0.5) / places_ - 0.5}, e, ambiguous);
        const double count = double(places_) * places_;
        for (std::size_t k = 0; k < e.litOfStratum.size(); ++k) {
            e.litShare += e.litOfStratum[k] / (count * stepsSeen_);
            if (seenOfStratum_[k] > 0) e.litOfStratum[k] /= count * seenOfStratum_[k];
        }
        if (traits_.texelCentres && !case_.fleeting)
            e.resolution = 0.5 * ambiguous / count + 0.5 * std::min(case_.ends, 4) / stepsInAll();
        e.integration =
            std::min(case_.ends, 4) * 0.5 / stepsInAll() + 0.5 * (traits_.texelCentres ? borderShare() : 0.0);
        return e;
    }

  private:
    double timeOf(int step) const { return (step + 0.5) / stepsInAll(); }
    bool isSeen(int step) const { return timeOf(step) >= case_.seenFrom && timeOf(step) <= case_.seenTo; }
    std::size_t stratumOf(int step) const { return static_cast<std::size_t>(timeOf(step) * strata_); }
    int stepsInAll() const {
        return traits_.times == SamplingTraits::Times::EvenInstants ? traits_.instants : strata_ * steps_;
    }

    /// The share of the receiver whose texel may differ from that of the position that represents it.
    double borderShare() const {
        return traits_.times == SamplingTraits::Times::OneInstant && case_.patchHeight > 0.1 ? 0.5 / places_ : 0.02;
    }

    dvec3 receiver(const dvec2& place, double u) const {
        const dvec3 centre = glm::mix(case_.receiverOpen, case_.receiverClose, u) - world_.origin();
        return centre + dvec3(place.x * case_.patchWidth, place.y * case_.patchHeight, 0.0);
    }

    void addPlace(const dvec2& place, Expectation& e, double& ambiguous) {
        if (traits_.firstAndLast) findRanges(place);
        const int steps = stepsInAll();
        for (int k = 0; k < steps; ++k) {
            if (!isSeen(k)) continue;
            const double u = timeOf(k);
            e.litOfStratum[stratumOf(k)] += litAt(place, u);
            if (traits_.texelCentres && !case_.fleeting) ambiguous += isAmbiguous(place, u) ? 1.0 / stepsSeen_ : 0.0;
        }
    }

    double litAt(const dvec2& place, double u) const {
        using Times = SamplingTraits::Times;
        if (traits_.times == Times::OneInstant) return isLit(place, 0.5, 0.5) ? 1.0 : 0.0;
        if (traits_.times != Times::RandomInStratum) return isLit(place, u, u) ? 1.0 : 0.0;
        const double stratum = std::floor(u * strata_);
        int lit = 0;
        for (int k = 0; k < steps_; ++k) lit += isLit(place, u, (stratum + (k + 0.5) / steps_) / strata_) ? 1 : 0;
        return double(lit) / steps_;
    }

    /// Visibility of the receiver at time u from casters at time v.
    bool isLit(const dvec2& place, double u, double v) const {
        const dvec3 point = receiver(place, u);
        if (!traits_.texelCentres) return isFree(point, v);
        const dvec3 p = world_.project(point, u);
        return isFreeInMap(world_.centreOfTexel(p), p.z, u, v);
    }

    bool isFree(const dvec3& point, double v) const {
        const dvec3 towards = world_.light(v) - point;
        for (std::size_t t = 0; t < world_.triangles(); ++t) {
            const std::optional<double> s = world_.meeting(t, v, point, towards);
            if (s && *s > nearestCaster && *s < 1.0) return false;
        }
        return true;
    }

    bool isFreeInMap(const dvec2& map, double depth, double u, double v) const {
        // Equal depths cast no shadow; the relative slack absorbs rounding.
        const double limit = depth - biasTexels_ * world_.texelWidth(depth) - 1e-9 * depth;
        const dvec3 from = world_.light(v), ray = world_.ray(map);
        for (std::size_t t = 0; t < world_.triangles(); ++t) {
            std::optional<double> distance = world_.meeting(t, v, from, ray);
            if (distance && traits_.movesDepth) distance = world_.planeDistance(t, u, world_.light(u), ray);
            if (traits_.firstAndLast) distance = rangeDistance(t, u);
            if (distance && *distance > world_.nearDistance() && *distance < limit) return false;
        }
        return true;
    }

    /// The first and last time at which each triangle covers the texel of a static receiver, and its depths then.
    void findRanges(const dvec2& place) {
        ranges_.assign(world_.triangles(), {});
        const int steps = 4 * strata_ * steps_;
        for (int k = 0; k < steps; ++k) {
            const double u = (k + 0.5) / steps;
            const dvec2 map = world_.centreOfTexel(world_.project(receiver(place, u), u));
            for (std::size_t t = 0; t < world_.triangles(); ++t) {
                const auto distance = world_.meeting(t, u, world_.light(u), world_.ray(map));
                if (!distance) continue;
                Range& range = ranges_[t];
                if (range.first > range.last) {
                    range.first = u;
                    range.firstDistance = *distance;
                }
                range.last = u;
                range.lastDistance = *distance;
            }
        }
    }

    std::optional<double> rangeDistance(std::size_t t, double u) const {
        const Range& range = ranges_[t];
        if (!(range.first <= u && u <= range.last)) return std::nullopt;
        const double length = range.last - range.first;
        return glm::mix(range.firstDistance, range.lastDistance, length > 0.0 ? (u - range.first) / length : 0.0);
    }

    /// Whether visibility at u changes if the texel is shifted by up to half its width.
    bool isAmbiguous(const dvec2& place, double u) const {
        const double at = traits_.times == SamplingTraits::Times::OneInstant ? 0.5 : u;
        const dvec3 p = world_.project(receiver(place, at), at);
        int lit = 0, tested = 0;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j, ++tested)
                lit += isFreeInMap(dvec2(p) + dvec2(i, j) * (0.5 * world_.texel()), p.z, at, at) ? 1 : 0;
        return lit != 0 && lit != tested;
    }

    struct Range {
        double first = 1.0, last = 0.0;
        double firstDistance = 0.0, lastDistance = 0.0;
    };

    const ClosedFormCase& case_;
    const SamplingTraits& traits_;
    int strata_;
    World world_;
    double biasTexels_;
    int places_ = 0, steps_ = 0;
    int stepsSeen_ = 0;
    std::vector<int> seenOfStratum_;
    std::vector<Range> ranges_;
};

}  // namespace

Expectation expectationOf(const ClosedFormCase& c, const SamplingTraits& traits, int samplesPerPixel, int mapSize) {
    CHECK(c.kind == ClosedFormCase::Kind::Picture);
    return Model(c, traits, samplesPerPixel, mapSize).result();
}

double independentAnswers(const ClosedFormCase& c, const SamplingTraits& traits, int mapSize) {
    if (!traits.texelCentres) return double(c.width) * c.height;
    // The receiver's distance, and so the width of its texels, is greatest at one of the ends.
    const LightPose open = c.scene->light(0.0), close = c.scene->light(1.0);
    const double farthest = std::max(open.position.z - c.receiverOpen.z, close.position.z - c.receiverClose.z);
    return std::max(1.0, c.patchHeight / (farthest * 2.0 * std::tan(open.outerConeAngle) / mapSize));
}

}  // namespace timeshade
