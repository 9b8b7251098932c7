#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Where vertices really are at instants inside a shutter, for the plan to compare with their straight paths: a few
/// vertices of each thing that moves, at its extremes and those of its bones.
struct InnerMotion {
    /// Vertices of one thing at one instant: the entries first .. first + count - 1 of the lists.
    struct Group {
        std::uint32_t thing = 0;  ///< index into `*things`
        double u = 0.0;           ///< 0 to 1
        bool jumped = false;      ///< with STEP keys as they are at this instant, not as in the shutter's middle
        std::uint32_t first = 0, count = 0;
    };
    std::vector<Group> groups;
    std::vector<std::uint32_t> vertices;               ///< of the scene's meshes
    std::vector<glm::dvec3> positions;                 ///< world space, one per entry of `vertices`
    const std::vector<std::string>* things = nullptr;  ///< names, for messages; owned by the scene
    /// Instants at which cameras and the light are worth a look: u in [0, 1], ascending.
    std::vector<double> instants;
};

/// The instants of a shutter at which its motion is looked at: a quarter, a half and three quarters of it, and `keys`
/// of them that lie inside; at most `mostInnerInstants`, evenly chosen, where there are more. Ascending, no two alike.
std::vector<double> innerInstants(std::vector<double> keys);

inline constexpr std::size_t mostInnerInstants = 64;

/// Of a list of points, the indices of those farthest along each axis and each diagonal: up to 14, ascending. What a
/// linear map moves farthest among all points is, nearly, among these.
std::vector<std::uint32_t> extremesOf(const std::vector<glm::vec3>& points, const std::vector<std::uint32_t>& among);

}  // namespace timeshade
