#pragma once

#include <string>

#include <glm/glm.hpp>

namespace timeshade {

/// A pinhole camera at one instant, in world space.
struct CameraPose {
    glm::dvec3 eye{0.0, 0.0, 0.0};
    glm::dmat3 axes{1.0};              ///< columns: right, up, back (the camera looks along -back); orthonormal
    double verticalFieldOfView = 0.8;  ///< radians, 0 < value < pi; the horizontal one follows from the image
    double nearDistance = 0.01;        ///< world units along the view direction, > 0; nothing nearer is seen
};

/// The pose that looks from eye towards target with `up` as near to vertical as can be. Safe where the view
/// direction is parallel to up, and where eye equals target.
CameraPose lookAt(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, double verticalFieldOfView,
                  double nearDistance);

/// A camera of the scene that can be chosen by name.
struct CameraBookmark {
    std::string name;
};

}  // namespace timeshade
