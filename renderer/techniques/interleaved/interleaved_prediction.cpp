#include "techniques/interleaved/interleaved_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade {

namespace {

/// Of what stands still in the light's frame, which is in a map of its own.
bool standsStill(const TriangleInMap& triangle) {
    return std::all_of(std::begin(triangle.corners), std::end(triangle.corners),
                       [](const PathInMap& corner) { return corner.open == corner.close; });
}

/// Positive on one side of a triangle and negative on the other, as the light sees it.
double sideSeen(const TriangleInMap& triangle, double u) {
    const glm::dvec3 a = triangle.corners[0].at(u), b = triangle.corners[1].at(u), c = triangle.corners[2].at(u);
    return glm::dot(a, glm::cross(b, c));
}

}  // namespace

std::optional<double> InterleavedPrediction::lit(const ReceiverInMap& receiver, double u) const {
    const int strata = form_.strata > 0 ? form_.strata : receiver.strata, phases = form_.side * form_.side;
    const double begin = std::floor(u * receiver.strata) / receiver.strata, end = begin + 1.0 / receiver.strata;
    const TriangleInMap& own = receiver.triangles[receiver.own];
    double lit = 0.0, sum = 0.0, litOfAll = 0.0, sumOfAll = 0.0;
    for (int slice = 0; slice < strata; ++slice) {
        const double share = std::min(end, (slice + 1.0) / strata) - std::max(begin, double(slice) / strata);
        if (share < 1e-9) continue;
        for (int phase = 0; phase < phases; ++phase) {
            const double time = (slice + (phase + 0.5) / phases) / strata, value = litInPhase(receiver, phase, time);
            litOfAll += share * value;
            sumOfAll += share;
            if (sideSeen(own, time) * sideSeen(own, u) <= 0.0) continue;
            lit += share * value;
            sum += share;
        }
    }
    return sum > 0.0 ? lit / sum : litOfAll / sumOfAll;
}

double InterleavedPrediction::litInPhase(const ReceiverInMap& receiver, int phase, double time) const {
    const glm::dvec3 p = receiver.path.at(time);
    const glm::dvec2 texels = glm::dvec2(p) / p.z * receiver.mapSize, first(phase % form_.side, phase / form_.side);
    const double side = form_.side;
    const glm::dvec2 nearest = first + side * glm::round((texels - 0.5 - first) / side);
    const int r = form_.pcfRadius;
    int lit = 0, tests = 0;
    for (int i = -r; i <= r; ++i)
        for (int j = -r; j <= r; ++j, ++tests)
            lit += isLit(receiver, (nearest + side * glm::dvec2(i, j) + 0.5) / receiver.mapSize, time) ? 1 : 0;
    return static_cast<double>(lit) / tests;
}

bool InterleavedPrediction::isLit(const ReceiverInMap& receiver, const glm::dvec2& centre, double time) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    const TriangleInMap& own = receiver.triangles[receiver.own];
    const double depth = form_.planeTest ? hitOf(own, centre, time).distance : receiver.path.at(time).z;
    // 0: of what moves, 1: of what stands still. A map holds the nearest triangle alone.
    double nearest[2] = {none, none};
    std::size_t seen[2] = {receiver.own, receiver.own};
    for (std::size_t i = 0; i < receiver.triangles.size(); ++i) {
        const PlaneHit hit = hitOf(receiver.triangles[i], centre, time);
        const int map = standsStill(receiver.triangles[i]) ? 1 : 0;
        if (!hit.inside || !(hit.distance > receiver.nearDistance) || hit.distance >= nearest[map]) continue;
        nearest[map] = hit.distance;
        seen[map] = i;
    }
    for (int map = 0; map < 2; ++map)
        if (seen[map] != receiver.own && nearest[map] < depth * (1.0 - form_.biasTexels * receiver.texelAngle) - 1e-9)
            return false;
    return true;
}

}  // namespace timeshade
