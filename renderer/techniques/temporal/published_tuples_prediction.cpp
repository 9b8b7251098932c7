#include "techniques/temporal/published_tuples_prediction.h"

#include <algorithm>

namespace timeshade {

namespace {

/// Corners 0 to 2 are the triangle's at u = 0, 3 to 5 the same at u = 1: the caps, then two faces a side.
constexpr int faces[8][3] = {{0, 1, 2}, {3, 4, 5}, {0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {2, 0, 3}, {2, 3, 5}};

/// NDC depth and one over the distance are linear in each other.
struct PrismPoint {
    double time, inverseDistance;
};

}  // namespace

std::optional<double> PublishedTuplesPrediction::casterDistance(const ReceiverInMap& receiver, std::size_t caster,
                                                                const glm::dvec2& position, double u, double) const {
    const TriangleInMap& triangle = receiver.triangles[caster];
    if (caster == receiver.own) return std::nullopt;
    PrismPoint first{2.0, 0.0}, last{-1.0, 0.0};
    for (const auto& face : faces) {
        TriangleInMap flat;
        glm::dvec3 times;
        for (int i = 0; i < 3; ++i) {
            times[i] = face[i] < 3 ? 0.0 : 1.0;
            flat.corners[i].open = flat.corners[i].close = triangle.corners[face[i] % 3].at(times[i]);
        }
        const PlaneHit hit = hitOf(flat, position, 0.0);
        if (!hit.inside || hit.distance < receiver.nearDistance) continue;
        const PrismPoint point{glm::dot(hit.inSpace, times), 1.0 / hit.distance};
        if (point.time < first.time) first = point;
        if (point.time > last.time) last = point;
    }
    if (!(first.time <= u && u <= last.time)) return std::nullopt;
    const double length = last.time - first.time, share = length > 0.0 ? (u - first.time) / length : 0.0;
    return 1.0 / glm::mix(first.inverseDistance, last.inverseDistance, share);
}

}  // namespace timeshade
