#include "techniques/deep/deep_prediction.h"

#include <algorithm>

namespace timeshade {

namespace {

constexpr int instants = 256;

/// Whether anything is nearer at the time v.
bool isFree(const ReceiverInMap& receiver, const glm::dvec2& position, double depth, double v) {
    return std::none_of(receiver.triangles.begin(), receiver.triangles.end(), [&](const TriangleInMap& triangle) {
        const PlaneHit hit = hitOf(triangle, position, v);
        return hit.inside && hit.distance > receiver.nearDistance && hit.distance < depth;
    });
}

}  // namespace

std::optional<double> DeepPrediction::lit(const ReceiverInMap& receiver, double u) const {
    const glm::dvec3 p = receiver.path.at(u);
    // Equal depths cast no shadow.
    const double depth = p.z * (1.0 - biasTexels_ * receiver.texelAngle - 1e-9);
    int free = 0;
    for (int i = -radius_; i <= radius_; ++i)
        for (int j = -radius_; j <= radius_; ++j) {
            const glm::dvec2 texel = receiver.texelCentre(glm::dvec2(p) / p.z) + glm::dvec2(i, j) / receiver.mapSize;
            for (int k = 0; k < instants; ++k) free += isFree(receiver, texel, depth, (k + 0.5) / instants) ? 1 : 0;
        }
    const int side = 2 * radius_ + 1;
    return static_cast<double>(free) / (static_cast<double>(instants) * side * side);
}

}  // namespace timeshade
