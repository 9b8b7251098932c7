#pragma once

#include <glm/glm.hpp>

namespace timeshade {

/// A rigid transform: p becomes axes * p + position.
struct RigidPose {
    glm::dvec3 position{0.0};
    glm::dmat3 axes{1.0};  ///< orthonormal, right-handed

    glm::dvec3 of(const glm::dvec3& p) const { return axes * p + position; }
};

/// The angle of the rotation from one to the other, in degrees, 0 to 180. Near 0 it has an error of some 1e-6.
double degreesBetween(const RigidPose& from, const RigidPose& to);

/// The pose that turns by `axes` and moves a point from one place to another.
RigidPose turnedAt(const glm::dmat3& axes, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace timeshade
