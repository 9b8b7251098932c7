#include "scene/deform.h"

#include <cmath>

#include "core/parallel.h"

namespace timeshade::gltf {

namespace {

/// Transforms normals like the inverse transpose, up to length, and is defined for singular matrices too.
struct NormalMatrix {
    explicit NormalMatrix(const glm::dmat4x3& m)
        : x(glm::cross(m[1], m[2])), y(glm::cross(m[2], m[0])), z(glm::cross(m[0], m[1])) {
        if (glm::dot(m[0], x) < 0.0) {  // the cofactors of a mirroring matrix point the other way
            x = -x;
            y = -y;
            z = -z;
        }
    }
    glm::vec3 operator()(const glm::dvec3& n, const glm::vec3& fallback) const {
        const glm::dvec3 world = x * n.x + y * n.y + z * n.z;
        const double square = glm::dot(world, world);
        return square > 1e-200 && square < 1e200 ? glm::vec3(world / std::sqrt(square)) : fallback;
    }
    glm::dvec3 x, y, z;
};

glm::dvec3 transformed(const glm::dmat4x3& m, const glm::dvec3& p) {
    return m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3];
}

struct Vertex {
    glm::dvec3 position;
    glm::dvec3 normal;
};

/// A morph target whose weight is not zero.
struct ActiveMorph {
    const MorphDeltas* deltas;
    double weight;
};

std::vector<ActiveMorph> activeMorphs(const Geometry& geometry, const std::vector<double>& weights) {
    std::vector<ActiveMorph> active;
    for (std::size_t i = 0; i < geometry.morphs.size() && i < weights.size(); ++i)
        if (weights[i] != 0.0) active.push_back({&geometry.morphs[i], weights[i]});
    return active;
}

Vertex morphed(const Geometry& geometry, const std::vector<ActiveMorph>& morphs, std::size_t v) {
    Vertex vertex{glm::dvec3(geometry.positions[v]), glm::dvec3(geometry.normals[v])};
    for (const auto& [deltas, weight] : morphs) {
        if (!deltas->positions.empty()) vertex.position += weight * glm::dvec3(deltas->positions[v]);
        if (!deltas->normals.empty()) vertex.normal += weight * glm::dvec3(deltas->normals[v]);
    }
    return vertex;
}

/// The weighted sum of a vertex's joints. A vertex whose weights are all zero follows its node.
glm::dmat4x3 blended(const Geometry& geometry, std::span<const glm::dmat4x3> joints, const glm::dmat4x3& rigid,
                     std::size_t v) {
    glm::dmat4x3 sum(0.0);
    double total = 0.0;
    for (const JointSet& set : geometry.jointSets) {
        for (int i = 0; i < 4; ++i) {
            const auto weight = static_cast<double>(set.weights[v][i]);
            if (weight == 0.0) continue;
            const glm::dmat4x3& joint = joints[set.joints[v][i]];
            for (int column = 0; column < 4; ++column) sum[column] += weight * joint[column];
            total += weight;
        }
    }
    return total > 0.0 ? sum : rigid;
}

/// As many as are worth a thread.
constexpr std::size_t verticesTogether = 1024;

}  // namespace

std::vector<glm::dmat4x3> jointMatrices(const SkinBinding& skin, const Pose& pose) {
    std::vector<glm::dmat4x3> matrices;
    matrices.reserve(skin.joints.size());
    for (std::size_t i = 0; i < skin.joints.size(); ++i)
        matrices.emplace_back(pose.worldFromNode[static_cast<std::size_t>(skin.joints[i])] * skin.jointFromMesh[i]);
    return matrices;
}

void deform(const Instance& instance, const Pose& pose, std::span<const glm::dmat4x3> joints,
            std::span<glm::dvec3> positions, std::span<glm::vec3> normals) {
    const Geometry& geometry = *instance.geometry;
    const auto node = static_cast<std::size_t>(instance.node);
    const std::vector<ActiveMorph> morphs = activeMorphs(geometry, pose.morphWeights[node]);
    const glm::dmat4x3 rigid(pose.worldFromNode[node]);
    const NormalMatrix rigidNormals(rigid);
    const bool skinned = !joints.empty() && !geometry.jointSets.empty();
    forEachOf(geometry.positions.size(), verticesTogether, [&](std::size_t v) {
        const Vertex vertex = morphed(geometry, morphs, v);
        if (skinned) {
            const glm::dmat4x3 world = blended(geometry, joints, rigid, v);
            positions[v] = transformed(world, vertex.position);
            normals[v] = NormalMatrix(world)(vertex.normal, geometry.normals[v]);
        } else {
            positions[v] = transformed(rigid, vertex.position);
            normals[v] = rigidNormals(vertex.normal, geometry.normals[v]);
        }
    });
}

}  // namespace timeshade::gltf
