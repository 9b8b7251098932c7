#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// The parts of a mesh that are constant while a scene plays: connectivity, materials, texture coordinates.
/// MotionMeshes of a scene share one, so that comparing pointers shows whether it must be uploaded again; where an
/// animation mirrors something, there is one for each set of mirrored instances, which differ in corner order alone.
struct MeshTopology {
    /// Vertex indices, counter-clockwise seen from the front; where an animation mirrors, in the middle of the shutter.
    std::vector<glm::u32vec3> triangles;
    std::vector<std::uint32_t> triangleMaterials;  ///< index into Scene::materials(), one per triangle
    std::vector<std::uint32_t> triangleInstances;  ///< mesh instance (node) of each triangle
    /// Texture coordinates 0, one per vertex: those of the base colour's image, with the material's transform applied.
    /// (0,0) where the file has none.
    std::vector<glm::vec2> textureCoordinates;
    /// Texture coordinates 1 (xy) and 2 (zw), one per vertex; empty where no material uses them.
    std::vector<glm::vec4> moreCoordinates;
    /// Linear RGBA in [0, 1], one per vertex, times which base colours count; empty where all are white.
    std::vector<glm::vec4> colours;
    std::size_t vertexCount = 0;
    std::size_t instanceCount = 0;
};

/// All triangles of a scene at the two ends of the shutter, in world space. Between the ends every vertex moves
/// linearly in u. This is the definition of the motion, for all techniques and for the oracle (docs/numerics.md,
/// "Motion").
struct MotionMesh {
    std::shared_ptr<const MeshTopology> topology;
    std::vector<glm::dvec3> positionsOpen;   ///< world space at u = 0, one per vertex
    std::vector<glm::dvec3> positionsClose;  ///< world space at u = 1
    std::vector<glm::vec3> normalsOpen;      ///< unit, smooth, for shading only
    std::vector<glm::vec3> normalsClose;

    /// Largest rotation of any instance or joint in this shutter, in degrees. At 15 degrees, linear vertex paths shrink
    /// an object by 0.9 % at u = 1/2.
    double largestTurnDegrees = 0.0;
};

}  // namespace timeshade
