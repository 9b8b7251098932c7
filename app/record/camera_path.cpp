#include "record/camera_path.h"

#include <glm/gtc/quaternion.hpp>

namespace timeshade {

CameraPose between(const CameraPose& from, const CameraPose& to, double share) {
    CameraPose pose;
    pose.eye = glm::mix(from.eye, to.eye, share);
    pose.axes = glm::mat3_cast(
        glm::slerp(glm::normalize(glm::quat_cast(from.axes)), glm::normalize(glm::quat_cast(to.axes)), share));
    pose.verticalFieldOfView = glm::mix(from.verticalFieldOfView, to.verticalFieldOfView, share);
    pose.nearDistance = glm::mix(from.nearDistance, to.nearDistance, share);
    return pose;
}

}  // namespace timeshade
