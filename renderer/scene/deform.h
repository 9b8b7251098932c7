#pragma once

#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "scene/geometry.h"
#include "scene/node_motion.h"

namespace timeshade::gltf {

/// The joints that deform an instance.
struct SkinBinding {
    std::vector<int> joints;                ///< nodes
    std::vector<glm::dmat4> jointFromMesh;  ///< inverse bind matrices, one per joint
};

/// One primitive of a mesh at one node, and its first vertex in the scene's list of vertices.
struct Instance {
    const Geometry* geometry = nullptr;
    int node = -1;
    int skin = -1;  ///< index of the scene's SkinBinding; -1: rigid
    std::size_t firstVertex = 0;
    bool moves = false;
    bool mirrored = false;  ///< in the rest pose
};

/// worldFromMesh for every joint of a binding, for blending.
std::vector<glm::dmat4x3> jointMatrices(const SkinBinding& skin, const Pose& pose);

/// Computes world positions and unit normals of an instance in a pose: morph targets first, then the joints or the
/// node. This is the only deformation in the program; all passes and both ends of the shutter use its results. `joints`
/// is empty for a rigid instance. The spans have one entry per vertex of the geometry.
void deform(const Instance& instance, const Pose& pose, std::span<const glm::dmat4x3> joints,
            std::span<glm::dvec3> positions, std::span<glm::vec3> normals);

}  // namespace timeshade::gltf
