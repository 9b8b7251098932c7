#include "scenes/mesh_scene.h"

#include <algorithm>
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
    for (const glm::dvec3& position : shape.positions) *positions++ = pose.of(position);
    for (const glm::vec3& normal : shape.normals) *normals++ = glm::normalize(turn * normal);
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
        const std::vector<glm::vec3>& colours = instance.shape->colours;
        if (!colours.empty()) {
            topology->colours.resize(topology->vertexCount - colours.size(), glm::vec4(1.0f));
            for (const glm::vec3& colour : colours) topology->colours.emplace_back(colour, 1.0f);
        }
        ++topology->instanceCount;
    }
    if (!topology->colours.empty()) topology->colours.resize(topology->vertexCount, glm::vec4(1.0f));
    return topology;
}

/// Vertices all over a shape that bends, for a look at its motion.
std::vector<std::uint32_t> spreadOver(const Shape& shape) {
    constexpr std::size_t most = 96;
    std::vector<std::uint32_t> some;
    const std::size_t step = shape.positions.size() / most + 1;
    for (std::size_t v = 0; v < shape.positions.size(); v += step) some.push_back(static_cast<std::uint32_t>(v));
    return some;
}

std::vector<std::uint32_t> allOf(const Shape& shape) {
    std::vector<std::uint32_t> all(shape.positions.size());
    std::iota(all.begin(), all.end(), 0u);
    return all;
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
        if (isNew && instance.motion)
            extremes->second = extremesOf({shape.positions.begin(), shape.positions.end()}, allOf(shape));
        if (isNew && instance.flesh) extremes->second = spreadOver(shape);
        things_.push_back(fmt::format("instance {}", things_.size()));
        extremes_.push_back(instance.moves() ? extremes->second : std::vector<std::uint32_t>{});
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
        for (std::size_t i = 0; instance.moves() && i < instants; ++i) {
            const double u = inner.instants[i];
            const RigidPose& pose = poses[number * instants + i];
            inner.groups.push_back({number, u, false, static_cast<std::uint32_t>(inner.vertices.size()),
                                    static_cast<std::uint32_t>(extremes.size())});
            const std::size_t first = inner.positions.size();
            inner.positions.resize(first + extremes.size());
            if (instance.flesh)
                instance.flesh->bend(clock_.during(openSeconds, closeSeconds, u), extremes, &inner.positions[first],
                                     nullptr);
            for (std::size_t e = 0; e < extremes.size(); ++e) {
                inner.vertices.push_back(static_cast<std::uint32_t>(firstVertices_[number]) + extremes[e]);
                if (!instance.flesh) inner.positions[first + e] = pose.of(instance.shape->positions[extremes[e]]);
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
    const auto timeAt = [&](double share) { return clock_.during(openSeconds, closeSeconds, share); };
    forEachOf(parts_.instances.size(), instancesTogether, [&](std::size_t number) {
        const MeshInstance& instance = parts_.instances[number];
        const std::size_t first = firstVertices_[number];
        if (instance.flesh) {
            const std::vector<std::uint32_t> all = allOf(*instance.shape);
            instance.flesh->bend(timeAt(0.0), all, &mesh.positionsOpen[first], &mesh.normalsOpen[first]);
            instance.flesh->bend(timeAt(1.0), all, &mesh.positionsClose[first], &mesh.normalsClose[first]);
        } else {
            const auto at = [&](double share) {
                return instance.motion ? instance.motion(timeAt(share)) : instance.pose;
            };
            place(*instance.shape, at(0.0), &mesh.positionsOpen[first], &mesh.normalsOpen[first]);
            place(*instance.shape, at(1.0), &mesh.positionsClose[first], &mesh.normalsClose[first]);
        }
        // In steps, because the two ends alone cannot distinguish a full turn from none.
        constexpr int steps = 4;
        for (int step = 0; instance.moves() && step < steps; ++step) {
            const double from = timeAt(static_cast<double>(step) / steps),
                         to = timeAt(static_cast<double>(step + 1) / steps);
            turns[number] += instance.flesh ? instance.flesh->turn(from, to)
                                            : degreesBetween(instance.motion(from), instance.motion(to));
        }
    });
    // Near 1 the arccosine has an error of some 1e-6 degrees.
    for (const double turn : turns)
        if (turn > 1e-4) mesh.largestTurnDegrees = std::max(mesh.largestTurnDegrees, turn);
    return mesh;
}

}  // namespace timeshade
