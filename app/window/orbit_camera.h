#pragma once

#include <glm/glm.hpp>

#include "scene/camera.h"
#include "scene/scene.h"

namespace timeshade {

/// A camera that the mouse moves around a point of interest. World space; +Y is up.
class OrbitCamera {
  public:
    /// Starts from a pose: the point of interest is the one on its line of sight nearest to the centre of the bounds.
    OrbitCamera(const CameraPose& pose, const Bounds& bounds);

    const CameraPose& pose() const { return pose_; }

    /// Turns around the point of interest, radians. Stops short of straight up and straight down.
    void orbit(double yaw, double pitch);
    /// Moves sideways, in heights of the picture at the distance of the point of interest.
    void pan(double right, double up);
    /// Multiplies the distance to the point of interest; it stays within what the scene makes sense of.
    void zoom(double factor);
    /// Takes the point, in world space, as the point of interest, and moves so that it is in the middle of the picture.
    void focus(const glm::dvec3& point);
    /// Flies to the right, up and ahead, in sizes of the scene; the point of interest comes along.
    void fly(const glm::dvec3& rightUpAhead);

  private:
    void place();

    CameraPose pose_;
    glm::dvec3 target_{0.0};
    double distance_ = 1.0;
    double nearest_ = 0.0, farthest_ = 1.0, size_ = 1.0;
    double nearDistance_ = 0.01;  ///< of the pose it started from
};

}  // namespace timeshade
