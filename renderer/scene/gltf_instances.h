#pragma once

#include <memory>
#include <vector>

#include "scene/deform.h"
#include "scene/motion_mesh.h"

namespace timeshade::gltf {

/// All triangles of a file, as instances in the world.
struct Stage {
    std::vector<std::vector<Geometry>> geometries;  ///< per mesh of the file; instances point into it
    std::vector<SkinBinding> skins;                 ///< per skin of the file
    std::vector<Instance> instances;
    std::shared_ptr<const MeshTopology> topology;
    std::vector<char> used;         ///< per vertex: it belongs to a triangle
    std::vector<int> turningNodes;  ///< nodes whose rotation moves triangles
    bool mayMirror = false;         ///< an animation scales something: what mirrors depends on the pose
};

/// One instance per primitive and node of the shown scene. The winding of mirrored instances is reversed, so that all
/// triangles are counter-clockwise in the rest pose. Throws Error if there is no triangle.
Stage buildStage(const Model& model, const NodeMotion& motion, std::vector<std::vector<Geometry>> geometries,
                 std::uint32_t defaultMaterial, std::vector<std::string>& notes);

/// Per instance: whether the pose mirrors it. Of a skin, whether the majority of its joints do.
std::vector<char> mirroredInstances(const Stage& stage, const Pose& pose);

/// The stage's topology with the triangles of exactly the mirrored instances turned round.
std::shared_ptr<const MeshTopology> topologyMirrored(const Stage& stage, const std::vector<char>& mirrored);

}  // namespace timeshade::gltf
