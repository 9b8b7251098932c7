#include "scenes/mesh_scene.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include <fmt/format.h>

#include "core/check.h"
#include "core/parallel.h"

namespace timeshade {

namespace {

/// As many instances as are worth a thread.
constexpr std::size_t instancesTogether = 64;

/// Writes the shape's vertices from those places on.
void place(const Shape& shape, const RigidPose& pose, glm::dvec3* positions, glm::vec3* normals) {
    const glm::mat3 turn(pose.axes);
    for (const glm::dvec3& position : shape.positions) *positions++ = pose.axes * position + pose.position;
    for (const glm::vec3& normal : shape.normals) *normals++ = glm::normalize(turn * normal);
}

double turnBetween(const glm::dmat3& from, const glm::dmat3& to) {
    const glm::dmat3 turn = to * glm::transpose(from);
    return glm::degrees(std::acos(std::clamp(0.5 * (turn[0][0] + turn[1][1] + turn[2][2] - 1.0), -1.0, 1.0)));
}

std::shared_ptr<const MeshTopology> topologyOf(const std::vector<MeshInstance>& instances) {
    auto topology = std::make_shared<MeshTopology>();
    for (const MeshInstance& instance : instances) {
        for (const glm::u32vec3& triangle : instance.shape->triangles) {
            topology->triangles.push_back(triangle + static_cast<std::uint32_t>(topology->vertexCount));
            topology->triangleMaterials.push_back(instance.material);
            topology->triangleInstances.push_back(static_cast<std::uint32_t>(topology->instanceCount));
        }
        const std::vector<glm::vec2>& coordinates = instance.shape->textureCoordinates;
        topology->textureCoordinates.insert(topology->textureCoordinates.end(), coordinates.begin(), coordinates.end());
        topology->vertexCount += instance.shape->positions.size();
        topology->textureCoordinates.resize(topology->vertexCount);
        ++topology->instanceCount;
    }
    return topology;
}

}  // namespace

MeshScene::MeshScene(SceneParts parts)
    : parts_(std::move(parts)), clock_(parts_.duration, true), topology_(topologyOf(parts_.instances)) {
    CHECK(!parts_.materials.empty());
    CHECK(!parts_.instances.empty());
    CHECK(!parts_.cameras.empty());
    CHECK(static_cast<bool>(parts_.light));
    for (const MeshInstance& instance : parts_.instances) CHECK_LT(instance.material, parts_.materials.size());
    for (const auto& [name, pose] : parts_.cameras) cameras_.push_back({name});
    std::map<const Shape*, std::vector<std::uint32_t>> known;
    std::size_t vertices = 0;
    for (const MeshInstance& instance : parts_.instances) {
        const Shape& shape = *instance.shape;
        firstVertices_.push_back(vertices);
        vertices += shape.positions.size();
        const auto [extremes, isNew] = known.try_emplace(&shape);
        if (isNew && instance.motion) {
            std::vector<std::uint32_t> all(shape.positions.size());
            std::iota(all.begin(), all.end(), 0u);
            extremes->second = extremesOf({shape.positions.begin(), shape.positions.end()}, all);
        }
        things_.push_back(fmt::format("instance {}", things_.size()));
        extremes_.push_back(instance.motion ? extremes->second : std::vector<std::uint32_t>{});
    }
}

InnerMotion MeshScene::innerMotion(double openSeconds, double closeSeconds) const {
    InnerMotion inner;
    if (!(closeSeconds > openSeconds)) return inner;
    inner.instants = innerInstants({});
    inner.things = &things_;
    const std::size_t instants = inner.instants.size();
    std::vector<RigidPose> poses(parts_.instances.size() * instants);
    forEachOf(parts_.instances.size(), instancesTogether, [&](std::size_t number) {
        const MeshInstance& instance = parts_.instances[number];
        for (std::size_t i = 0; instance.motion && i < instants; ++i)
            poses[number * instants + i] = instance.motion(clock_.during(openSeconds, closeSeconds, inner.instants[i]));
    });
    for (std::uint32_t number = 0; number < parts_.instances.size(); ++number) {
        const MeshInstance& instance = parts_.instances[number];
        const std::vector<std::uint32_t>& extremes = extremes_[number];
        for (std::size_t i = 0; instance.motion && i < instants; ++i) {
            const double u = inner.instants[i];
            const RigidPose& pose = poses[number * instants + i];
            inner.groups.push_back({number, u, false, static_cast<std::uint32_t>(inner.vertices.size()),
                                    static_cast<std::uint32_t>(extremes.size())});
            for (const std::uint32_t vertex : extremes) {
                inner.vertices.push_back(static_cast<std::uint32_t>(firstVertices_[number]) + vertex);
                inner.positions.push_back(pose.axes * instance.shape->positions[vertex] + pose.position);
            }
        }
    }
    return inner;
}

MotionMesh MeshScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh;
    mesh.topology = topology_;
    for (auto* positions : {&mesh.positionsOpen, &mesh.positionsClose}) positions->resize(topology_->vertexCount);
    for (auto* normals : {&mesh.normalsOpen, &mesh.normalsClose}) normals->resize(topology_->vertexCount);
    std::vector<double> turns(parts_.instances.size(), 0.0);
    forEachOf(parts_.instances.size(), instancesTogether, [&](std::size_t number) {
        const MeshInstance& instance = parts_.instances[number];
        const std::size_t first = firstVertices_[number];
        const auto at = [&](double share) {
            return instance.motion ? instance.motion(clock_.during(openSeconds, closeSeconds, share)) : instance.pose;
        };
        const RigidPose open = at(0.0), close = at(1.0);
        place(*instance.shape, open, &mesh.positionsOpen[first], &mesh.normalsOpen[first]);
        place(*instance.shape, close, &mesh.positionsClose[first], &mesh.normalsClose[first]);
        if (!instance.motion) return;
        // In steps, because the two ends alone cannot distinguish a full turn from none.
        constexpr int steps = 4;
        glm::dmat3 before = open.axes;
        for (int step = 1; step <= steps; ++step) {
            const glm::dmat3 now = step == steps ? close.axes : at(static_cast<double>(step) / steps).axes;
            turns[number] += turnBetween(before, now);
            before = now;
        }
    });
    // Near 1 the arccosine has an error of some 1e-6 degrees.
    for (const double turn : turns)
        if (turn > 1e-4) mesh.largestTurnDegrees = std::max(mesh.largestTurnDegrees, turn);
    return mesh;
}

}  // namespace timeshade
