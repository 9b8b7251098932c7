#include "window/seen_point.h"

#include <cmath>
#include <limits>

namespace timeshade {

namespace {

/// Distance along the ray at which it meets the triangle (Moeller and Trumbore 1997); infinity where it does not.
double distanceTo(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3 (&corners)[3]) {
    constexpr double none = std::numeric_limits<double>::infinity();
    const glm::dvec3 a = corners[1] - corners[0], b = corners[2] - corners[0];
    const glm::dvec3 p = glm::cross(direction, b);
    const double determinant = glm::dot(a, p);
    if (determinant == 0.0) return none;
    const glm::dvec3 from = origin - corners[0];
    const double u = glm::dot(from, p) / determinant;
    const glm::dvec3 q = glm::cross(from, a);
    const double v = glm::dot(direction, q) / determinant;
    if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0)) return none;
    const double distance = glm::dot(b, q) / determinant;
    return distance > 0.0 ? distance : none;
}

}  // namespace

std::optional<glm::dvec3> seenPoint(const MotionMesh& mesh, const CameraPose& pose, double aspectRatio, double x,
                                    double y) {
    const double half = std::tan(0.5 * pose.verticalFieldOfView);
    const glm::dvec3 direction =
        glm::normalize(pose.axes * glm::dvec3((2.0 * x - 1.0) * half * aspectRatio, (1.0 - 2.0 * y) * half, -1.0));
    double nearest = std::numeric_limits<double>::infinity();
    for (const glm::u32vec3& triangle : mesh.topology->triangles) {
        glm::dvec3 corners[3];
        for (int i = 0; i < 3; ++i)
            corners[i] = 0.5 * (mesh.positionsOpen[triangle[i]] + mesh.positionsClose[triangle[i]]);
        const double distance = distanceTo(pose.eye, direction, corners);
        const double ahead = distance * glm::dot(direction, -pose.axes[2]);
        if (distance < nearest && ahead >= pose.nearDistance) nearest = distance;
    }
    if (!std::isfinite(nearest)) return std::nullopt;
    return pose.eye + nearest * direction;
}

}  // namespace timeshade
