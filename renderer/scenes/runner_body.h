#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "scenes/shape.h"
#include "scenes/skin.h"

namespace timeshade {

/// The bones of a runner, who at rest stands on y = 0 and looks along z; x is to the left. In metres.
enum Bone : std::uint32_t { pelvisBone, chestBone, headBone, firstLimbBone };
/// Of each limb; knees and elbows turn half as far as the bones below them.
enum LimbBone : std::uint32_t { thigh, knee, shin, foot, toes, upperArm, elbow, forearm, limbBones };
enum Side : std::uint32_t { left, right };
constexpr std::uint32_t boneOf(Side side, LimbBone bone) {
    return firstLimbBone + std::uint32_t{side} * std::uint32_t{limbBones} + std::uint32_t{bone};
}
constexpr std::size_t boneCount = boneOf(right, limbBones);

/// Where bones meet at rest, on the left; on the right x is negative.
struct RunnerJoints {
    glm::dvec3 hip{0.095, 0.93, 0.0}, knee{0.115, 0.51, 0.005}, ankle{0.135, 0.085, -0.02}, ball{0.14, 0.0, 0.11};
    glm::dvec3 shoulder{0.178, 1.42, -0.02}, elbow{0.353, 1.194, -0.02}, wrist{0.508, 0.993, -0.01};
    glm::dvec3 waist{0.0, 1.08, -0.01}, neck{0.0, 1.47, -0.02};
};
glm::dvec3 onSide(Side side, const glm::dvec3& place);

/// The runner's surface, closed and coloured, and which bones its vertices follow.
struct RunnerBody {
    std::shared_ptr<const Shape> shape;
    std::vector<Influences> influences;
};

/// With triangles about as large as the cell, in metres: 0.0046 makes some 265,000. Computed once for each size.
const RunnerBody& runnerBody(double cell);

}  // namespace timeshade
