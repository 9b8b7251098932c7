#include "window/orbit_camera.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

namespace timeshade {

namespace {
constexpr double steepestPitch = 1.55;  // radians: a little short of straight up, where yaw loses its meaning

glm::dmat3 turnAround(const glm::dvec3& axis, double angle) {
    return glm::dmat3(glm::rotate(glm::dmat4(1.0), angle, axis));
}

/// Rounding of many small turns would otherwise shear the axes.
glm::dmat3 orthonormal(const glm::dmat3& axes) {
    const glm::dvec3 back = glm::normalize(axes[2]);
    const glm::dvec3 right = glm::normalize(glm::cross(axes[1], back));
    return {right, glm::cross(back, right), back};
}
}  // namespace

OrbitCamera::OrbitCamera(const CameraPose& pose, const Bounds& bounds) : pose_(pose), nearDistance_(pose.nearDistance) {
    const double size = std::max(bounds.diagonal(), 1e-9);
    size_ = size;
    nearest_ = 1e-3 * size;
    farthest_ = 50.0 * size;
    distance_ = std::clamp(glm::dot(bounds.centre() - pose.eye, -pose.axes[2]), 0.02 * size, farthest_);
    target_ = pose.eye - pose.axes[2] * distance_;
}

void OrbitCamera::orbit(double yaw, double pitch) {
    const double now = std::asin(std::clamp(pose_.axes[2].y, -1.0, 1.0));
    const double wanted = std::clamp(now + pitch, std::min(now, -steepestPitch), std::max(now, steepestPitch));
    const glm::dmat3 tilted = pose_.axes * turnAround({1.0, 0.0, 0.0}, now - wanted);
    pose_.axes = orthonormal(turnAround({0.0, 1.0, 0.0}, yaw) * tilted);
    place();
}

void OrbitCamera::pan(double right, double up) {
    const double height = 2.0 * std::tan(0.5 * pose_.verticalFieldOfView) * distance_;
    target_ += height * (right * pose_.axes[0] + up * pose_.axes[1]);
    place();
}

void OrbitCamera::zoom(double factor) {
    distance_ = std::clamp(distance_ * factor, nearest_, farthest_);
    place();
}

void OrbitCamera::focus(const glm::dvec3& point) {
    target_ = point;
    place();
}

void OrbitCamera::fly(const glm::dvec3& rightUpAhead) {
    target_ += size_ * (pose_.axes * glm::dvec3(rightUpAhead.x, rightUpAhead.y, -rightUpAhead.z));
    place();
}

void OrbitCamera::place() {
    pose_.eye = target_ + pose_.axes[2] * distance_;
    pose_.nearDistance = std::min(nearDistance_, 0.05 * distance_);
}

}  // namespace timeshade
