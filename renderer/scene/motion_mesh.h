#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// What does not change while a scene plays: connectivity, materials, texture coordinates.
/// Shared by every MotionMesh of a scene, so that a pointer comparison tells whether to upload again.
struct MeshTopology {
    std::vector<glm::u32vec3> triangles;           ///< vertex indices, counter-clockwise seen from the front
    std::vector<std::uint32_t> triangleMaterials;  ///< index into Scene::materials(), one per triangle
    std::vector<std::uint32_t> triangleInstances;  ///< which mesh instance (node) a triangle belongs to
    std::vector<glm::vec2> textureCoordinates;     ///< one per vertex; (0,0) where the file has none
    std::size_t vertexCount = 0;
    std::size_t instanceCount = 0;
};

/// All triangles of a scene at the two ends of the shutter, in world space. Between the ends every vertex
/// moves linearly in u (design section 1): that is the ground truth, not an approximation of it.
struct MotionMesh {
    std::shared_ptr<const MeshTopology> topology;
    std::vector<glm::dvec3> positionsOpen;   ///< world space at u = 0, one per vertex
    std::vector<glm::dvec3> positionsClose;  ///< world space at u = 1
    std::vector<glm::vec3> normalsOpen;      ///< unit, smooth, for shading only
    std::vector<glm::vec3> normalsClose;

    /// Largest turn of any instance or joint in this shutter, in degrees. Above 15 the linear vertex paths
    /// shrink an object by more than 0.9 % half-way, and the plan says so.
    double largestTurnDegrees = 0.0;
};

}  // namespace timeshade
