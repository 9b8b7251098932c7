#pragma once

#include <string>

#include <glm/glm.hpp>

namespace timeshade {

/// A pinhole camera at one instant, in world space.
struct CameraPose {
    glm::dvec3 eye{0.0, 0.0, 0.0};
    glm::dmat3 axes{1.0};  ///< columns: right, up, back (the camera looks along -back); orthonormal
    double verticalFieldOfView =
        0.8;                     ///< radians, 0 < value < pi; the horizontal one follows from the image's aspect ratio
    double nearDistance = 0.01;  ///< world units along the view direction, > 0; nothing nearer is visible
};

/// The pose that looks from eye to target with the image's vertical axis as close to `up` as possible. Also defined if
/// the view direction is parallel to up and if eye equals target.
CameraPose lookAt(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, double verticalFieldOfView,
                  double nearDistance);

/// A camera of the scene, chosen by name.
struct CameraBookmark {
    std::string name;
};

}  // namespace timeshade
