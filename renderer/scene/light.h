#pragma once

#include <string>

#include <glm/glm.hpp>

namespace timeshade {

enum class LightKind { Spot, Directional };

/// The scene's light at one instant, in world space. Units as in KHR_lights_punctual: candela for a spot, lux
/// for a directional light, already multiplied by the colour.
struct LightPose {
    LightKind kind = LightKind::Spot;
    glm::dvec3 position{0.0, 10.0, 0.0};  ///< not used by a directional light
    glm::dmat3 axes{1.0};                 ///< columns: right, up, back; light travels along -back; orthonormal
    glm::dvec3 intensity{1.0, 1.0, 1.0};
    double innerConeAngle = 0.0;       ///< radians from the axis, 0 <= inner < outer
    double outerConeAngle = 0.785398;  ///< radians from the axis, <= 1.48 (85 degrees)
};

}  // namespace timeshade
