#pragma once

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// Packs a mesh for the GPU, relative to `origin` (subtracted in double). Positions per triangle: three vertices at
/// u = 0, three at u = 1 (18 floats), 1 if the material is double-sided or 0, material index. Shading per triangle:
/// three normals at u = 0, three at u = 1, three texture coordinates (24 floats).
MeshTexels packMesh(const MotionMesh& mesh, const std::vector<Material>& materials, const glm::dvec3& origin);

/// The number of triangles with a vertex that moves in world space.
std::size_t countMovingTriangles(const MotionMesh& mesh);

}  // namespace timeshade
