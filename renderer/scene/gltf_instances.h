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
};

/// One instance per primitive and node of the shown scene. The winding of mirrored nodes is reversed, so that all
/// triangles are counter-clockwise in the rest pose. Throws Error if there is no triangle.
Stage buildStage(const Model& model, const NodeMotion& motion, std::vector<std::vector<Geometry>> geometries,
                 std::uint32_t defaultMaterial, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
