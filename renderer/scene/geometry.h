#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// How the vertices of one morph target differ from the rest shape. Empty normals: they do not differ.
struct MorphDeltas {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
};

/// Four joints of a skin and their shares. The shares of a vertex sum to one over all its sets, or are all zero
/// where the vertex follows no joint.
struct JointSet {
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> weights;
};

/// Triangles of one material in the space of their mesh, at rest. One entry per vertex in every list.
struct Geometry {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< unit
    std::vector<glm::vec2> textureCoordinates;
    std::vector<JointSet> jointSets;
    std::vector<MorphDeltas> morphs;
    std::vector<glm::u32vec3> triangles;
    int material = -1;
};

/// Sums the normals of the triangles around each vertex, weighted by their area. Vertices that triangles do not
/// share keep flat normals, as glTF asks for; those of no triangle get (0, 1, 0).
std::vector<glm::vec3> generatedNormals(const std::vector<glm::vec3>& positions,
                                        const std::vector<glm::u32vec3>& triangles);

}  // namespace timeshade
