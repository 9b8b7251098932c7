#include "cases/changed_scene.h"

#include <optional>
#include <utility>

namespace timeshade {

ChangedScene::ChangedScene(std::shared_ptr<const Scene> scene, WorldChange world, MeshChange mesh)
    : scene_(std::move(scene)), world_(world), meshChange_(std::move(mesh)) {
    // The bounds of the rotated box would be larger, and so would views fitted to them. Only the centre and the
    // diagonal of bounds are used, so those are preserved.
    const Bounds& given = scene_->bounds();
    const glm::dvec3 half = 0.5 * world_.scale * (given.high - given.low), centre = moved(given.centre());
    bounds_.add(centre - half);
    bounds_.add(centre + half);
}

void ChangedScene::reverse(double openSeconds, double closeSeconds) {
    reversed_ = true;
    mirror_ = openSeconds + closeSeconds;
}

CameraPose ChangedScene::moved(CameraPose pose) const {
    pose.eye = moved(pose.eye);
    pose.axes = world_.rotation * pose.axes;
    pose.nearDistance *= world_.scale;
    return pose;
}

LightPose ChangedScene::moved(LightPose pose) const {
    pose.position = moved(pose.position);
    pose.axes = world_.rotation * pose.axes;
    return pose;
}

CameraPose ChangedScene::camera(std::size_t index, double seconds) const {
    return moved(scene_->camera(index, reversed_ ? mirror_ - seconds : seconds));
}

LightPose ChangedScene::light(double seconds) const {
    return moved(scene_->light(reversed_ ? mirror_ - seconds : seconds));
}

ShutterEnds<CameraPose> ChangedScene::cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const {
    const auto ends = reversed_ ? scene_->cameraEnds(index, mirror_ - closeSeconds, mirror_ - openSeconds)
                                : scene_->cameraEnds(index, openSeconds, closeSeconds);
    return {moved(reversed_ ? ends.close : ends.open), moved(reversed_ ? ends.open : ends.close)};
}

ShutterEnds<LightPose> ChangedScene::lightEnds(double openSeconds, double closeSeconds) const {
    const auto ends = reversed_ ? scene_->lightEnds(mirror_ - closeSeconds, mirror_ - openSeconds)
                                : scene_->lightEnds(openSeconds, closeSeconds);
    return {moved(reversed_ ? ends.close : ends.open), moved(reversed_ ? ends.open : ends.close)};
}

MotionMesh ChangedScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh = reversed_ ? scene_->motionMesh(mirror_ - closeSeconds, mirror_ - openSeconds)
                                : scene_->motionMesh(openSeconds, closeSeconds);
    if (reversed_) {
        std::swap(mesh.positionsOpen, mesh.positionsClose);
        std::swap(mesh.normalsOpen, mesh.normalsClose);
    }
    for (auto* positions : {&mesh.positionsOpen, &mesh.positionsClose})
        for (glm::dvec3& position : *positions) position = moved(position);
    for (auto* normals : {&mesh.normalsOpen, &mesh.normalsClose})
        for (glm::vec3& normal : *normals) normal = glm::vec3(world_.rotation * glm::dvec3(normal));
    return meshChange_ ? meshChange_(std::move(mesh)) : mesh;
}

MotionMesh withCornersTurned(MotionMesh mesh) {
    auto topology = std::make_shared<MeshTopology>(*mesh.topology);
    for (glm::u32vec3& t : topology->triangles) t = {t.y, t.z, t.x};
    mesh.topology = topology;
    return mesh;
}

namespace {

/// t with its corners rotated so that the first is the one that s does not have; nothing unless they share exactly two.
std::optional<glm::u32vec3> turnedAwayFrom(const glm::u32vec3& s, glm::u32vec3 t) {
    const auto has = [&s](std::uint32_t v) { return v == s.x || v == s.y || v == s.z; };
    for (int i = 0; i < 3; ++i, t = {t.y, t.z, t.x})
        if (!has(t.x) && has(t.y) && has(t.z)) return t;
    return std::nullopt;
}

bool isParallelogram(const std::vector<glm::dvec3>& positions, const glm::u32vec4& v) {
    const glm::dvec3 across = positions[v.x] + positions[v.z], other = positions[v.y] + positions[v.w];
    return glm::length(across - other) <= 1e-9 * glm::length(positions[v.x] - positions[v.z]);
}

}  // namespace

MotionMesh withDiagonalsTurned(MotionMesh mesh) {
    auto topology = std::make_shared<MeshTopology>(*mesh.topology);
    std::vector<glm::u32vec3>& triangles = topology->triangles;
    for (std::size_t i = 0; i + 1 < triangles.size(); ++i) {
        const auto first = turnedAwayFrom(triangles[i + 1], triangles[i]),
                   second = turnedAwayFrom(triangles[i], triangles[i + 1]);
        // The same orientation: the common edge has opposite directions in the two triangles.
        if (!first || !second || first->y != second->z || first->z != second->y) continue;
        const glm::u32vec4 around(first->x, first->y, second->x, first->z);
        if (!isParallelogram(mesh.positionsOpen, around) || !isParallelogram(mesh.positionsClose, around)) continue;
        triangles[i] = {around.x, around.y, around.z};
        triangles[i + 1] = {around.x, around.z, around.w};
        ++i;
    }
    mesh.topology = topology;
    return mesh;
}

MotionMesh subdivided(MotionMesh mesh) {
    auto topology = std::make_shared<MeshTopology>(*mesh.topology);
    topology->triangles.clear();
    topology->triangleMaterials.clear();
    topology->triangleInstances.clear();
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
        for (auto* positions : {&mesh.positionsOpen, &mesh.positionsClose})
            positions->push_back(0.5 * ((*positions)[a] + (*positions)[b]));
        for (auto* normals : {&mesh.normalsOpen, &mesh.normalsClose}) {
            const glm::vec3 sum = (*normals)[a] + (*normals)[b];
            normals->push_back(glm::length(sum) > 0.0f ? glm::normalize(sum) : (*normals)[a]);
        }
        const auto between = [&](auto& list) {
            if (!list.empty()) list.push_back(0.5f * (list[a] + list[b]));
        };
        between(topology->textureCoordinates);
        between(topology->moreCoordinates);
        between(topology->colours);
        return static_cast<std::uint32_t>(mesh.positionsOpen.size() - 1);
    };
    const MeshTopology& given = *mesh.topology;
    for (std::size_t i = 0; i < given.triangles.size(); ++i) {
        const glm::u32vec3 t = given.triangles[i];
        const std::uint32_t xy = middle(t.x, t.y), yz = middle(t.y, t.z), zx = middle(t.z, t.x);
        for (const glm::u32vec3& piece : {glm::u32vec3(t.x, xy, zx), glm::u32vec3(xy, t.y, yz),
                                          glm::u32vec3(zx, yz, t.z), glm::u32vec3(xy, yz, zx)}) {
            topology->triangles.push_back(piece);
            topology->triangleMaterials.push_back(given.triangleMaterials[i]);
            topology->triangleInstances.push_back(given.triangleInstances[i]);
        }
    }
    topology->vertexCount = mesh.positionsOpen.size();
    mesh.topology = topology;
    return mesh;
}

MotionMesh withQuad(MotionMesh mesh, const glm::dvec3 (&corners)[4]) {
    auto topology = std::make_shared<MeshTopology>(*mesh.topology);
    const auto first = static_cast<std::uint32_t>(mesh.positionsOpen.size());
    const glm::vec3 normal(glm::normalize(glm::cross(corners[1] - corners[0], corners[2] - corners[0])));
    for (const glm::dvec3& corner : corners) {
        mesh.positionsOpen.push_back(corner);
        mesh.positionsClose.push_back(corner);
        mesh.normalsOpen.push_back(normal);
        mesh.normalsClose.push_back(normal);
        topology->textureCoordinates.emplace_back(0.0f);
        if (!topology->moreCoordinates.empty()) topology->moreCoordinates.emplace_back(0.0f);
        if (!topology->colours.empty()) topology->colours.emplace_back(1.0f);
    }
    for (const glm::u32vec3& t :
         {glm::u32vec3(first, first + 1, first + 2), glm::u32vec3(first, first + 2, first + 3)}) {
        topology->triangles.push_back(t);
        topology->triangleMaterials.push_back(0);
        topology->triangleInstances.push_back(static_cast<std::uint32_t>(topology->instanceCount));
    }
    ++topology->instanceCount;
    topology->vertexCount = mesh.positionsOpen.size();
    mesh.topology = topology;
    return mesh;
}

}  // namespace timeshade
