#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

namespace timeshade {

/// Differences of one morph target from the rest shape, per vertex. Empty normals: no difference.
struct MorphDeltas {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
};

/// Four joints of a skin and their weights, per vertex. The weights of a vertex sum to one over all its sets, or are
/// all zero if it follows no joint.
struct JointSet {
    std::vector<glm::u16vec4> joints;
    std::vector<glm::vec4> weights;
};

/// Triangles of one material in mesh space, at rest. All lists have one entry per vertex, unless they may be empty.
struct Geometry {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< unit
    std::vector<glm::vec2> textureCoordinates;
    std::vector<glm::vec4> moreCoordinates;  ///< may be empty; this and the next as in MeshTopology
    std::vector<glm::vec4> colours;          ///< may be empty
    std::vector<JointSet> jointSets;
    std::vector<MorphDeltas> morphs;
    std::vector<glm::u32vec3> triangles;
    int material = -1;
};

/// Area-weighted mean of the normals of the triangles at each vertex. Vertices that are not shared get flat normals, as
/// glTF requires; vertices of no triangle get (0, 1, 0).
std::vector<glm::vec3> generatedNormals(const std::vector<glm::vec3>& positions,
                                        const std::vector<glm::u32vec3>& triangles);

}  // namespace timeshade
