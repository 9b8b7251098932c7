#include "scene/camera.h"

#include <cmath>

namespace timeshade {

CameraPose lookAt(const glm::dvec3& eye, const glm::dvec3& target, const glm::dvec3& up, double verticalFieldOfView,
                  double nearDistance) {
    glm::dvec3 back = eye - target;
    const double distance = glm::length(back);
    back = distance > 0.0 ? back / distance : glm::dvec3(0.0, 0.0, 1.0);

    // If up is parallel to the view direction or zero, the world axis farthest from the view direction replaces it.
    glm::dvec3 right = glm::cross(up, back);
    if (!(glm::length(right) > 1e-9 * glm::length(up)) || !(glm::length(up) > 0.0)) {
        const glm::dvec3 size = glm::abs(back);
        const glm::dvec3 stand = size.y <= size.x && size.y <= size.z ? glm::dvec3(0.0, 1.0, 0.0)
                                 : size.z <= size.x                   ? glm::dvec3(0.0, 0.0, 1.0)
                                                                      : glm::dvec3(1.0, 0.0, 0.0);
        right = glm::cross(stand, back);
    }
    right = glm::normalize(right);
    return {eye, glm::dmat3(right, glm::cross(back, right), back), verticalFieldOfView, nearDistance};
}

}  // namespace timeshade
