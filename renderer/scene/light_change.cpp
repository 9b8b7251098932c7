#include "scene/light_change.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

#include "scene/camera.h"

namespace timeshade {

namespace {

const glm::dvec3 up(0.0, 1.0, 0.0);

glm::dmat3 turnAbout(const glm::dvec3& axis, double degrees) {
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), glm::radians(degrees), axis));
}

/// Spots from where they are, suns from any place on the way.
void place(LightPose& light, const LightPose& atOwnFrame, const LightChange& change, const glm::dvec3& centre) {
    const bool spot = light.kind == LightKind::Spot;
    const glm::dvec3 apart = atOwnFrame.position - centre;
    const double own = spot ? glm::length(apart) : 1.0;
    const double distance = spot ? change.distance.value_or(own > 0.0 ? own : 1.0) : 1.0;
    const glm::dvec3 ownTowards = !spot ? atOwnFrame.axes[2] : own > 0.0 ? apart / own : up;
    const glm::dvec3 towards = change.direction ? vectorOf(*change.direction) : ownTowards;
    const glm::dvec3 eye = centre + distance * towards;
    if (spot) light.position = eye;
    light.axes = lookAt(towards, glm::dvec3(0.0), up, 1.0, 1.0).axes;
}

/// Straight up or down there is no horizontal axis but the light's own.
glm::dvec3 axisOfRising(const LightPose& light) {
    const glm::dvec3 axis = glm::cross(light.axes[2], up);
    const double length = glm::length(axis);
    return length > 1e-9 ? axis / length : -light.axes[0];
}

}  // namespace

glm::dvec3 vectorOf(const LightDirection& direction) {
    const double azimuth = glm::radians(direction.azimuth), elevation = glm::radians(direction.elevation);
    return {std::cos(elevation) * std::sin(azimuth), std::sin(elevation), std::cos(elevation) * std::cos(azimuth)};
}

LightDirection directionOf(const glm::dvec3& towards) {
    const double flat = std::hypot(towards.x, towards.z);
    return {flat > 0.0 ? glm::degrees(std::atan2(towards.x, towards.z)) : 0.0,
            glm::degrees(std::atan2(towards.y, flat))};
}

LightDirection directionOf(const LightPose& light, const glm::dvec3& centre) {
    const glm::dvec3 apart = light.position - centre;
    const bool hasPlace = light.kind == LightKind::Spot && glm::length(apart) > 0.0;
    return directionOf(hasPlace ? apart : light.axes[2]);
}

LightPose lightAtOwnFrame(const Scene& scene) {
    return scene.light(scene.defaults().frame / scene.defaults().framesPerSecond);
}

LightPose changed(const LightPose& own, const LightPose& atOwnFrame, const LightChange& change,
                  const glm::dvec3& centre, double frames) {
    LightPose light = own;
    if (change.places()) place(light, atOwnFrame, change, centre);
    if (change.cone && light.kind == LightKind::Spot) {
        const double inner = light.innerConeAngle / light.outerConeAngle;
        light.outerConeAngle = glm::radians(*change.cone);
        light.innerConeAngle = inner * light.outerConeAngle;
    }
    light.intensity *= change.intensity;
    const double passed = change.heldAt.value_or(frames);
    if (light.kind == LightKind::Spot) light.position += passed * change.move;
    if (change.rise != 0.0) light.axes = turnAbout(axisOfRising(light), passed * change.rise) * light.axes;
    if (change.turn != 0.0) light.axes = turnAbout(up, passed * change.turn) * light.axes;
    return light;
}

}  // namespace timeshade
