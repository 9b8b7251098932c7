#include "techniques/intervals/intervals_prediction.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace timeshade {

namespace {

glm::dvec3 edgesAt(const TriangleInMap& triangle, const glm::dvec2& position, double u) {
    glm::dvec2 q[3];
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 corner = triangle.corners[i].at(u);
        q[i] = glm::dvec2(corner) - position * corner.z;
    }
    glm::dvec3 e;
    for (int i = 0; i < 3; ++i) {
        const glm::dvec2 &a = q[(i + 1) % 3], &b = q[(i + 2) % 3];
        e[i] = a.x * b.y - a.y * b.x;
    }
    return e;
}

/// The times inside (0, 1), ascending, at which an edge passes the position, and 0 and 1. Edge functions are quadratics
/// in u, given by three of their values.
std::vector<double> timesOfEdges(const TriangleInMap& triangle, const glm::dvec2& position) {
    const glm::dvec3 open = edgesAt(triangle, position, 0.0), middle = edgesAt(triangle, position, 0.5),
                     close = edgesAt(triangle, position, 1.0);
    std::vector<double> times{0.0, 1.0};
    for (int i = 0; i < 3; ++i) {
        const double a = 2.0 * (open[i] + close[i]) - 4.0 * middle[i], b = close[i] - open[i] - a, c = open[i];
        const double discriminant = b * b - 4.0 * a * c;
        if (discriminant < 0.0) continue;
        const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
        for (const double root : {q / a, c / q})
            if (root > 0.0 && root < 1.0) times.push_back(root);
    }
    std::sort(times.begin(), times.end());
    return times;
}

/// 1, -1: inside, seen from either side; 0: outside.
int sideAt(const TriangleInMap& triangle, const glm::dvec2& position, double u) {
    const glm::dvec3 e = edgesAt(triangle, position, u);
    if (e.x >= 0.0 && e.y >= 0.0 && e.z >= 0.0) return e.x + e.y + e.z > 0.0 ? 1 : 0;
    return e.x <= 0.0 && e.y <= 0.0 && e.z <= 0.0 ? -1 : 0;
}

}  // namespace

std::optional<double> IntervalsPrediction::lit(const ReceiverInMap& receiver, double u) const {
    if (!bilinear_) return std::nullopt;
    const glm::dvec3 p = receiver.path.at(u);
    const glm::dvec2 place = glm::dvec2(p) / p.z * receiver.mapSize - 0.5, corner = glm::floor(place),
                     weight = place - corner;
    const double depth = p.z * (1.0 - biasTexels_ * receiver.texelAngle - 1e-9);
    double lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        const glm::dvec2 off(i & 1, i >> 1), share = glm::mix(1.0 - weight, weight, off);
        const glm::dvec2 texel = (corner + off + 0.5) / receiver.mapSize;
        bool isFree = true;
        for (std::size_t caster = 0; caster < receiver.triangles.size() && isFree; ++caster) {
            const auto distance = casterDistance(receiver, caster, texel, u, u);
            isFree = !(distance && *distance > receiver.nearDistance && *distance < depth);
        }
        lit += isFree ? share.x * share.y : 0.0;
    }
    return lit;
}

std::optional<double> PlaneIntervalsPrediction::casterDistance(const ReceiverInMap& receiver, std::size_t caster,
                                                               const glm::dvec2& position, double u, double) const {
    if (caster == receiver.own) return std::nullopt;
    const PlaneHit hit = hitOf(receiver.triangles[caster], position, u);
    if (!hit.inside || hit.distance <= receiver.nearDistance) return std::nullopt;
    const PlaneHit plane = hitOf(receiver.triangles[receiver.own], position, u);
    return hit.distance * receiver.path.at(u).z / plane.distance;
}

std::optional<double> PublishedIntervalsPrediction::casterDistance(const ReceiverInMap& receiver, std::size_t caster,
                                                                   const glm::dvec2& position, double u, double) const {
    const TriangleInMap& triangle = receiver.triangles[caster];
    if (caster == receiver.own || sideAt(triangle, position, u) == 0) return std::nullopt;
    const std::vector<double> times = timesOfEdges(triangle, position);
    auto last = std::upper_bound(times.begin(), times.end() - 1, u), first = last - 1;
    const auto sideBetween = [&](auto a) { return sideAt(triangle, position, 0.5 * (*a + *(a + 1))); };
    const int side = sideBetween(first);
    if (side == 0) return std::nullopt;
    while (first != times.begin() && sideBetween(first - 1) == side) --first;
    while (last + 1 != times.end() && sideBetween(last) == side) ++last;
    const double length = (*last - *first) / pieces_,
                 piece = length > 0.0 ? std::min(std::floor((u - *first) / length), pieces_ - 1.0) : 0.0;
    const double begin = *first + piece * length, share = length > 0.0 ? (u - begin) / length : 0.0;
    return glm::mix(hitOf(triangle, position, begin).distance, hitOf(triangle, position, begin + length).distance,
                    share);
}

}  // namespace timeshade
