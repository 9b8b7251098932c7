#pragma once

#include <optional>

#include <glm/glm.hpp>

namespace timeshade {

enum class GroundChoice {
    Auto,  ///< where a file has no surface below its things that could receive their shadow
    On,
    Off
};

/// Whether a file's scene gets a ground, and which.
struct GroundSettings {
    GroundChoice choice = GroundChoice::Auto;
    std::optional<double> height;  ///< world units; fitted where not given
    std::optional<double> size;    ///< side of the square, world units, > 0; fitted where not given
    bool operator==(const GroundSettings&) const = default;
};

/// A horizontal square that faces up, in world space.
struct GroundSquare {
    glm::dvec3 centre{0.0};
    double side = 1.0;  ///< along x and z
    bool operator==(const GroundSquare&) const = default;
};

}  // namespace timeshade
