#pragma once

#include <memory>
#include <vector>

#include "scene/deform.h"
#include "scene/motion_mesh.h"

namespace timeshade::gltf {

/// Everything of a file that has triangles, placed in the world.
struct Stage {
    std::vector<std::vector<Geometry>> geometries;  ///< per mesh of the file; instances point into it
    std::vector<SkinBinding> skins;                 ///< per skin of the file
    std::vector<Instance> instances;
    std::shared_ptr<const MeshTopology> topology;
    std::vector<char> used;         ///< per vertex: some triangle has it
    std::vector<int> turningNodes;  ///< nodes whose rotation turns triangles
};

/// One instance per primitive and node of the shown scene. Triangles of mirrored nodes are turned round, so that
/// all wind counter-clockwise in the rest pose. Error where there is no triangle at all.
Stage buildStage(const Model& model, const NodeMotion& motion, std::vector<std::vector<Geometry>> geometries,
                 std::uint32_t defaultMaterial, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
