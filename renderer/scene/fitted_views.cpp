#include "scene/fitted_views.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

namespace {

constexpr double pi = 3.14159265358979323846;

/// Half of the diagonal; not 0 even if the bounds are a point.
double radiusOf(const Bounds& bounds) { return std::max(0.5 * bounds.diagonal(), 1e-9); }

glm::dvec3 corner(const Bounds& bounds, int index) {
    return {index & 1 ? bounds.high.x : bounds.low.x, index & 2 ? bounds.high.y : bounds.low.y,
            index & 4 ? bounds.high.z : bounds.low.z};
}

}  // namespace

CameraPose fittedCamera(const Bounds& bounds) {
    constexpr double fieldOfView = 0.65;
    constexpr double margin = 1.06;
    constexpr double aspect = 4.0 / 3.0;
    const glm::dvec3 centre = bounds.centre();
    const double radius = radiusOf(bounds);
    const glm::dvec3 up(0.0, 1.0, 0.0);
    CameraPose pose = lookAt(centre + glm::dvec3(0.55, 0.5, 1.0), centre, up, fieldOfView, 0.01);

    const double slopeY = std::tan(0.5 * fieldOfView) / margin;
    const double slopeX = slopeY * aspect;
    double distance = radius;
    for (int i = 0; i < 8; ++i) {
        const glm::dvec3 seen = glm::transpose(pose.axes) * (corner(bounds, i) - centre);
        distance = std::max({distance, seen.z + std::abs(seen.x) / slopeX, seen.z + std::abs(seen.y) / slopeY});
    }
    pose.eye = centre + distance * pose.axes[2];
    pose.nearDistance = 1e-3 * distance;
    return pose;
}

LightPose fittedLight(const Bounds& bounds) {
    constexpr double radiiAway = 3.0;
    const glm::dvec3 centre = bounds.centre();
    const double radius = radiusOf(bounds);
    const glm::dvec3 eye = centre + radiiAway * radius * glm::normalize(glm::dvec3(-0.45, 1.0, 0.35));
    LightPose light;
    light.kind = LightKind::Spot;
    light.position = eye;
    light.axes = lookAt(eye, centre, glm::dvec3(0.0, 1.0, 0.0), 1.0, 1.0).axes;
    light.outerConeAngle = 1.1 * std::asin(1.0 / radiiAway);
    light.innerConeAngle = 0.9 * light.outerConeAngle;
    light.intensity = glm::dvec3(pi * radiiAway * radiiAway * radius * radius);
    return light;
}

}  // namespace timeshade
