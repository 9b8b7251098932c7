#pragma once

#include <string>
#include <vector>

#include "scene/geometry.h"
#include "scene/gltf_model.h"

namespace timeshade::gltf {

struct Budget {
    std::size_t most = 0;  ///< vertices, and triangles, of all instances together
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t morphs = 0;  ///< vertices of morph targets
};

/// Reads the primitives of every mesh that a node of the shown scene uses; other meshes stay empty.
/// Error on broken data, and before anything large is allocated when the budget does not last.
std::vector<std::vector<Geometry>> readGeometries(const Model& model, Budget budget, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
