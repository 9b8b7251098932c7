#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "scene/motion_mesh.h"

namespace timeshade {

/// Edges that are divided in the middle, and the vertices that lie there, behind all others. Edges whose ends are at
/// the same places are divided alike, so that no gap opens where a surface has two vertices at one place.
class EdgeSplits {
  public:
    /// Divides the longest edges of what moves in this mesh until it has so many triangles, at most three more; all of
    /// them where even that is too few. Lengths are those at the opening.
    EdgeSplits(const MotionMesh& mesh, std::size_t triangles);

    /// With the new vertices and the triangles between them. `bare` has the edges of the mesh above.
    MeshTopology divided(const MeshTopology& bare) const;
    /// Appends the new vertices to a list of the old ones' positions, and to that of their normals.
    void append(std::vector<glm::dvec3>& positions, std::vector<glm::vec3>& normals) const;

  private:
    struct Edge {
        std::uint32_t a = 0, b = 0;  ///< its ends; in the same order wherever the same edge stands twice
        bool crease = false;
    };
    using Ends = std::pair<std::uint32_t, std::uint32_t>;  ///< ascending

    std::size_t firstNew_ = 0;
    std::vector<Edge> edges_;             ///< one per new vertex
    std::map<Ends, std::uint32_t> news_;  ///< number of the new vertex on an edge
};

}  // namespace timeshade
