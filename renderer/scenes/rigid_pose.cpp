#include "scenes/rigid_pose.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

double degreesBetween(const RigidPose& from, const RigidPose& to) {
    const glm::dmat3 turn = to.axes * glm::transpose(from.axes);
    return glm::degrees(std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0)));
}

RigidPose turnedAt(const glm::dmat3& axes, const glm::dvec3& from, const glm::dvec3& to) {
    return {to - axes * from, axes};
}

}  // namespace timeshade
