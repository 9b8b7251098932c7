#include "cases/expectation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "core/check.h"
#include "plan/frame_plan.h"

namespace timeshade {

namespace {

using glm::dvec2;
using glm::dvec3;
using Times = SamplingTraits::Times;

constexpr double nearestCaster = 1e-7;  // of the way to the light: less than any receiver's clearance
/// Share of a depth by which rounding in a map and in its test may move it: some units in the last place of what a
/// rasteriser interpolates.
constexpr double depthRounding = 4e-6;

/// The case's scene as its light's map sees it.
class World {
  public:
    World(const ClosedFormCase& c, int strata, const MapSize& mapSize)
        : case_(c), plan_(FramePlanner(*c.scene).plan(c.request(strata, mapSize, 1))) {
        for (const glm::u32vec3& t : plan_.mesh->topology->triangles) {
            TriangleInMap& triangle = triangles_.emplace_back();
            for (int i = 0; i < 3; ++i)
                triangle.corners[i] = pathOf(plan_.mesh->positionsOpen[t[i]], plan_.mesh->positionsClose[t[i]]);
        }
    }

    std::size_t triangles() const { return triangles_.size(); }
    /// place: in [-1/2, 1/2]^2 over the visible part of the receiver.
    ReceiverInMap receiver(const dvec2& place) const {
        const dvec3 offset(place.x * case_.patchWidth, place.y * case_.patchHeight, 0.0);
        const PathInMap path = pathOf(case_.receiverOpen + offset, case_.receiverClose + offset);
        const bool inFirst = hitOf(triangles_[case_.firstReceiver], dvec2(path.open) / path.open.z, 0.0).inside;
        return {triangles_,
                case_.firstReceiver + (inFirst ? 0u : 1u),
                path,
                plan_.request.mapSize.sides(),
                plan_.request.samplesPerPixel,
                static_cast<double>(plan_.light.block.nearDistance),
                glm::length(plan_.light.open.right) / plan_.request.mapSize.shorterSide()};
    }

  private:
    PathInMap pathOf(const dvec3& open, const dvec3& close) const {
        return {inMap(open, plan_.light.open.eye), inMap(close, plan_.light.close.eye)};
    }
    dvec3 inMap(const dvec3& point, const dvec3& light) const {
        const ViewEnd& end = plan_.light.open;  // the axes are constant
        const dvec3 v = point - plan_.origin - light;
        const double distance = glm::dot(v, glm::normalize(glm::cross(end.up, end.right)));
        const dvec3 w = v - distance * end.corner;
        return {glm::dot(w, end.right) / glm::dot(end.right, end.right), glm::dot(w, end.up) / glm::dot(end.up, end.up),
                distance};
    }

    const ClosedFormCase& case_;
    FramePlan plan_;
    std::vector<TriangleInMap> triangles_;
};

/// Integrates numerically over positions on the receiver, times of the receiver and times of the casters.
class Model {
  public:
    /// margin: share of a receiver's depth by which a caster must be nearer, beyond the bias.
    Model(const ClosedFormCase& c, const TechniqueStatement& stated, int strata, const MapSize& mapSize, double margin)
        : case_(c),
          stated_(stated),
          traits_(stated.traits),
          strata_(strata),
          margin_(margin),
          world_(c, strata, mapSize) {
        // Fewer steps for scenes of many triangles, to bound the run time.
        const bool crowd = world_.triangles() > 100;
        places_ = crowd ? 4 : 6;
        steps_ = crowd ? 12 : 48;
        if (traits_.times == Times::RandomInStratum) steps_ = crowd ? 6 : 16;
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
                addPlace(world_.receiver({(i + 0.5) / places_ - 0.5, (j + 0.5) / places_ - 0.5}), e, ambiguous);
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
    /// Where a frame is drawn at several instants, they are the times of its samples.
    int stepsInAll() const { return stated_.renders > 1 ? stated_.renders : strata_ * steps_; }

    /// The share of the receiver whose texel may differ from that of the position that represents it.
    double borderShare() const { return stated_.isOfOneInstant() && case_.patchHeight > 0.1 ? 0.5 / places_ : 0.02; }

    void addPlace(const ReceiverInMap& receiver, Expectation& e, double& ambiguous) {
        std::vector<double> lit;
        bool instants = true;
        for (int k = 0; k < stepsInAll(); ++k) {
            const double u = timeOf(k);
            const std::optional<double> own = stated_.prediction->lit(receiver, u);
            lit.push_back(own ? *own : litAt(receiver, u));
            instants = instants && !own;
            if (isSeen(k) && traits_.texelCentres && !case_.fleeting)
                ambiguous += isAmbiguous(receiver, u) ? 1.0 / stepsSeen_ : 0.0;
        }
        if (instants) averageOverFootprint(lit);
        for (int k = 0; k < stepsInAll(); ++k)
            if (isSeen(k)) e.litOfStratum[stratumOf(k)] += lit[static_cast<std::size_t>(k)];
    }

    void averageOverFootprint(std::vector<double>& lit) const {
        if (stated_.footprint.time == Footprint::Time::Instant) return;
        const std::size_t parts = stated_.footprint.time == Footprint::Time::Stratum ? std::size_t(strata_) : 1;
        for (std::size_t part = 0; part < parts; ++part) {
            const auto begin = lit.begin() + std::ptrdiff_t(lit.size() * part / parts),
                       end = lit.begin() + std::ptrdiff_t(lit.size() * (part + 1) / parts);
            std::fill(begin, end, std::accumulate(begin, end, 0.0) / double(end - begin));
        }
    }

    /// For a receiver seen at the instant u.
    double litAt(const ReceiverInMap& receiver, double u) const {
        if (traits_.times != Times::RandomInStratum) return litWith(receiver, instantOf(u), instantOf(u));
        const int strata = traits_.strata > 0 ? traits_.strata : strata_;
        const double stratum = std::floor(u * strata);
        double lit = 0.0;
        for (int k = 0; k < steps_; ++k) lit += litWith(receiver, u, (stratum + (k + 0.5) / steps_) / strata);
        return lit / steps_;
    }

    double instantOf(double u) const { return stated_.isOfOneInstant() ? 0.5 : u; }

    /// Visibility of the receiver at time u from casters at time v.
    double litWith(const ReceiverInMap& receiver, double u, double v) const {
        const dvec3 p = receiver.path.at(u);
        const dvec2 position = dvec2(p) / p.z;
        const Prediction& prediction = *stated_.prediction;
        if (!traits_.texelCentres) return isFree(prediction, receiver, {position, p.z, u, v}) ? 1.0 : 0.0;
        const int reach = static_cast<int>(stated_.footprint.filterTexels / 2.0);  // a filter of tests, as wide
        int lit = 0;
        for (int i = -reach; i <= reach; ++i)
            for (int j = -reach; j <= reach; ++j) {
                const dvec2 texel = receiver.texelCentre(position) + dvec2(i, j) / receiver.mapSize;
                lit += isFree(prediction, receiver, {texel, p.z, u, v}) ? 1 : 0;
            }
        return lit / ((2.0 * reach + 1.0) * (2.0 * reach + 1.0));
    }

    /// A test of a receiver's depth at a map position, as seen at time u, with casters at time v.
    struct Test {
        dvec2 position;
        double depth, u, v;
    };

    bool isFree(const Prediction& prediction, const ReceiverInMap& receiver, const Test& test) const {
        const double bias = traits_.texelCentres ? traits_.biasTexels * receiver.texelAngle + margin_ : nearestCaster,
                     nearest = traits_.texelCentres ? receiver.nearDistance : 0.0;
        for (std::size_t caster = 0; caster < receiver.triangles.size(); ++caster) {
            const auto distance = prediction.casterDistance(receiver, caster, test.position, test.u, test.v);
            if (distance && *distance > nearest && *distance < test.depth * (1.0 - bias)) return false;
        }
        return true;
    }

    /// Whether visibility at u changes if the texel is shifted by up to half its width, whatever else a technique does.
    bool isAmbiguous(const ReceiverInMap& receiver, double u) const {
        const double at = instantOf(u);
        const dvec3 p = receiver.path.at(at);
        int lit = 0, tested = 0;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j, ++tested) {
                const dvec2 shifted = dvec2(p) / p.z + 0.5 * dvec2(i, j) / receiver.mapSize;
                lit += isFree(Prediction(), receiver, {shifted, p.z, at, at}) ? 1 : 0;
            }
        return lit != 0 && lit != tested;
    }

    const ClosedFormCase& case_;
    const TechniqueStatement& stated_;
    const SamplingTraits& traits_;
    int strata_;
    double margin_;
    World world_;
    int places_ = 0, steps_ = 0;
    int stepsSeen_ = 0;
    std::vector<int> seenOfStratum_;
};

}  // namespace

Expectation expectationOf(const ClosedFormCase& c, const TechniqueStatement& stated, int samplesPerPixel,
                          const MapSize& mapSize) {
    CHECK(c.kind == ClosedFormCase::Kind::Picture);
    const bool tied = stated.traits.texelCentres && stated.traits.biasTexels == 0.0;
    const double margin = tied ? depthRounding : 1e-9;  // equal depths cast no shadow
    Expectation e = Model(c, stated, samplesPerPixel, mapSize, margin).result();
    if (tied) e.ties = e.litShare - Model(c, stated, samplesPerPixel, mapSize, -margin).result().litShare;
    return e;
}

double independentAnswers(const ClosedFormCase& c, const SamplingTraits& traits, const MapSize& mapSize) {
    if (!traits.texelCentres) return double(c.width) * c.height;
    // The receiver's distance, and so the width of its texels, is greatest at one of the ends.
    const LightPose open = c.scene->light(0.0), close = c.scene->light(1.0);
    const double farthest = std::max(open.position.z - c.receiverOpen.z, close.position.z - c.receiverClose.z);
    return std::max(1.0, c.patchHeight / (farthest * 2.0 * std::tan(open.outerConeAngle) / mapSize.height));
}

}  // namespace timeshade
