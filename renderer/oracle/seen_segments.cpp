#include "oracle/seen_segments.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "oracle/swept_line.h"

namespace timeshade::oracle {

namespace {

constexpr double shortest = 0x1p-40;

/// All of a box lies behind the eye, throughout.
class BehindTheEye {
  public:
    explicit BehindTheEye(const PositionRay& ray) : ray_(ray), along_(0.5 * (ray.direction[0] + ray.direction[1])) {
        if (glm::dot(along_, ray.direction[0]) <= 0.0 || glm::dot(along_, ray.direction[1]) <= 0.0)
            along_ = glm::dvec3(0.0);
    }
    bool holds(const SweptBox& box, double pad) const {
        for (int end = 0; end < 2; ++end) {
            double farthest = 0.0;
            for (int c = 0; c < 3; ++c)
                farthest +=
                    along_[c] * ((along_[c] > 0.0 ? box.high[end][c] + pad : box.low[end][c] - pad) - ray_.eye[end][c]);
            if (farthest >= 0.0) return false;
        }
        return true;
    }

  private:
    const PositionRay& ray_;
    glm::dvec3 along_;
};

std::vector<SeenTriangle> candidatesOf(const PositionRay& ray, const MovingTriangles& triangles, const SweptBvh& bvh) {
    using RealVector = glm::tvec3<Real>;
    const VectorPolynomial d = VectorPolynomial::between(RealVector(ray.direction[0]), RealVector(ray.direction[1]));
    const VectorPolynomial eye = VectorPolynomial::between(RealVector(ray.eye[0]), RealVector(ray.eye[1]));
    const SweptLine line(d, cross(eye, d));
    const BehindTheEye behind(ray);
    // Far above what doubles round in boxes and coefficients.
    const double pad = 1e-10 * (bvh.largestCoordinate() + glm::length(ray.eye[0]) + glm::length(ray.eye[1]));
    std::vector<std::uint32_t> ids;
    bvh.forEachUnless([&](const SweptBox& box) { return behind.holds(box, pad) || line.misses(box, pad); },
                      [&](std::uint32_t id) { ids.push_back(id); });
    std::sort(ids.begin(), ids.end());  // the search meets them in an order of no meaning
    std::vector<SeenTriangle> candidates;
    for (const std::uint32_t id : ids) {
        candidates.emplace_back(ray, triangles, id);
        if (candidates.back().spans().empty()) candidates.pop_back();
    }
    return candidates;
}

/// Goes over the spans of all candidates in time, and finds the nearest one between any two changes.
class Sweep {
  public:
    explicit Sweep(const std::vector<SeenTriangle>& candidates) : candidates_(candidates) {}

    std::vector<SeenSegment> result() {
        std::vector<double> cuts{0.0, 1.0};
        std::vector<std::pair<TimeSpan, std::uint32_t>> spans;
        for (std::uint32_t i = 0; i < candidates_.size(); ++i)
            for (const TimeSpan& span : candidates_[i].spans()) {
                spans.emplace_back(span, i);
                cuts.insert(cuts.end(), {span.begin, span.end});
            }
        std::sort(cuts.begin(), cuts.end());
        std::sort(spans.begin(), spans.end(), [](const auto& a, const auto& b) {
            return std::pair(a.first.begin, a.second) < std::pair(b.first.begin, b.second);
        });
        std::vector<std::pair<TimeSpan, std::uint32_t>> active;
        auto next = spans.begin();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            std::erase_if(active, [&](const auto& span) { return span.first.end <= cuts[i]; });
            for (; next != spans.end() && next->first.begin <= cuts[i]; ++next)
                if (next->first.end > cuts[i]) active.push_back(*next);
            std::vector<std::uint32_t> present;
            for (const auto& span : active) present.push_back(span.second);
            resolve(cuts[i], cuts[i + 1], present);
        }
        return finished();
    }

  private:
    /// What is seen from a to b, throughout which all of `present` are met and no others.
    void resolve(double a, double b, const std::vector<std::uint32_t>& present) {
        const std::optional<double> middle = timeBetween(a, b);
        if (!middle) return;
        if (present.empty()) return add(NO_TRIANGLE, b);
        std::uint32_t first = present.front();
        for (const std::uint32_t i : present)
            if (i != first && candidates_[i].isBefore(candidates_[first], *middle)) first = i;
        std::vector<double> cuts{a, b};
        for (const std::uint32_t i : present)
            for (const double time : ordersOf(first, i))
                if (a < time && time < b) cuts.push_back(time);
        if (cuts.size() == 2) return add(candidates_[first].id(), b);
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) resolve(cuts[i], cuts[i + 1], present);
    }

    const std::vector<double>& ordersOf(std::uint32_t a, std::uint32_t b) {
        static const std::vector<double> none;
        if (a == b) return none;
        const auto [found, isNew] = orders_.try_emplace(std::minmax(a, b));
        if (isNew) candidates_[found->first.first].addOrderChanges(candidates_[found->first.second], found->second);
        return found->second;
    }

    void add(std::uint32_t triangle, double until) {
        if (segments_.empty() || segments_.back().triangle != triangle)
            segments_.push_back({triangle, segments_.empty() ? 0.0 : segments_.back().u1, until});
        segments_.back().u1 = until;
    }

    /// Without the shortest ones.
    std::vector<SeenSegment> finished() const {
        std::vector<SeenSegment> kept;
        for (const SeenSegment& s : segments_) {
            const bool tooShort = s.u1 - s.u0 < shortest;
            if (!kept.empty() && (tooShort || kept.back().triangle == s.triangle))
                kept.back().u1 = s.u1;
            else if (!tooShort)
                kept.push_back(s);
        }
        kept.front().u0 = 0.0;
        kept.back().u1 = 1.0;
        return kept;
    }

    const std::vector<SeenTriangle>& candidates_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::vector<double>> orders_;
    std::vector<SeenSegment> segments_;
};

}  // namespace

PositionRay positionRay(const FramePlan& plan, glm::vec2 place, glm::dvec2 aside) {
    const ViewEnd* ends[2] = {&plan.camera.open, &plan.camera.close};
    // The same division of floats as that of a camera sample.
    const glm::dvec2 position = glm::dvec2(place / plan.camera.block.size) + aside / glm::dvec2(plan.camera.block.size);
    PositionRay ray;
    for (int end = 0; end < 2; ++end) {
        ray.eye[end] = ends[end]->eye;
        ray.direction[end] = ends[end]->corner + position.x * ends[end]->right + position.y * ends[end]->up;
    }
    ray.nearDistance = static_cast<double>(plan.camera.block.nearDistance);
    return ray;
}

CameraRay rayAt(const PositionRay& ray, double u) {
    return {u, ray.eye[0] * (1.0 - u) + ray.eye[1] * u, ray.direction[0] * (1.0 - u) + ray.direction[1] * u};
}

std::vector<SeenSegment> seenSegments(const PositionRay& ray, const MovingTriangles& triangles, const SweptBvh& bvh) {
    const std::vector<SeenTriangle> candidates = candidatesOf(ray, triangles, bvh);
    return Sweep(candidates).result();
}

}  // namespace timeshade::oracle
