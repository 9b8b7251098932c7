#pragma once

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// Packs a mesh for the GPU. Positions per triangle, in this order: three vertices at u = 0, three at u = 1 (18
/// floats), 1 if the material is two-sided, the material's number. Shading: three normals at u = 0, three at u = 1,
/// three texture coordinates (24 floats).
MeshTexels packMesh(const MotionMesh& mesh, const std::vector<Material>& materials, const glm::dvec3& origin);

/// Triangles with a vertex that moves in the world.
std::size_t countMovingTriangles(const MotionMesh& mesh);

}  // namespace timeshade
