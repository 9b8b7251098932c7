#pragma once

#include <string>

#include <glm/glm.hpp>

namespace timeshade {

enum class LightKind { Spot, Directional };

/// The scene's light at one instant, in world space.
struct LightPose {
    LightKind kind = LightKind::Spot;
    glm::dvec3 position{0.0, 10.0, 0.0};  ///< unused by directional lights
    glm::dmat3 axes{1.0};                 ///< columns: right, up, back; orthonormal; light travels along -back
    glm::dvec3 intensity{1.0, 1.0, 1.0};  ///< linear RGB, times candela (spot) or lux (directional)
    double innerConeAngle = 0.0;          ///< radians from the axis, 0 <= inner < outer
    double outerConeAngle = 0.785398;     ///< radians from the axis, <= 1.48 (85 degrees)
    double range = 0.0;  ///< of a spot: at this distance its light has faded to nothing; 0: it never does
};

}  // namespace timeshade
