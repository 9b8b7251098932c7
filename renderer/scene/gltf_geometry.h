#pragma once

#include <string>
#include <vector>

#include "scene/geometry.h"
#include "scene/gltf_model.h"
#include "scene/loading.h"

namespace timeshade::gltf {

/// Limits on the size of a scene, and what has been used so far.
struct Budget {
    std::size_t most = 0;  ///< limit on vertices, and on triangles, of all instances together
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    std::size_t morphs = 0;  ///< vertices of morph targets
};

/// The most triangles that a primitive may become; 0 where it has none to draw. Its accessors must be valid.
std::uint64_t mostTrianglesOf(const Model& model, const Primitive& primitive);

/// Reads the primitives of every mesh that the shown scene uses; other meshes stay empty. Throws Error for broken data,
/// and, before anything large is allocated, if the budget is exceeded.
std::vector<std::vector<Geometry>> readGeometries(const Model& model, Budget budget, std::vector<std::string>& notes,
                                                  const LoadingWatch& watch);

}  // namespace timeshade::gltf
