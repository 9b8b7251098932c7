#include "support/eventful_scene.h"

#include <algorithm>
#include <cmath>

#include "support/awkward_numbers.h"

namespace timeshade {

namespace {

/// A path that pauses in most frames: it moves in one of `pauses`.
std::vector<glm::dvec3> wander(AwkwardNumbers& numbers, glm::dvec3 from, double step, std::uint32_t pauses) {
    std::vector<glm::dvec3> path{from};
    for (int i = 0; i < EventfulScene::frames; ++i) {
        glm::dvec3 next = path.back();
        if (numbers.oneIn(pauses)) {
            const auto way = [&] { return static_cast<double>(numbers.between(-1.0f, 1.0f)) * step; };
            const double x = way(), y = way(), z = way();
            next += glm::dvec3(x, y, 0.3 * z);
        }
        path.push_back(next);
    }
    return path;
}

}  // namespace

EventfulScene::EventfulScene(std::uint32_t seed, bool directionalLight) : directional_(directionalLight) {
    AwkwardNumbers numbers(seed);
    const auto number = [&](float low, float high) { return static_cast<double>(numbers.between(low, high)); };
    quads_.push_back({Path(frames + 1, glm::dvec3(0.0)), Path(frames + 1, glm::dvec3(5, 0, 0)), glm::dvec3(0, 5, 0)});
    for (int i = 0; i < 14; ++i) {
        const double x = number(-4, 4), y = number(-4, 4), z = number(0.2f, 5);
        const double right = number(0.2f, 0.8f), up = number(0.2f, 0.8f), tilt = number(-0.4f, 0.4f);
        const std::uint32_t lively = i < 5 ? 1 : 4;  // the first ones never stop
        Quad quad{wander(numbers, {x, y, z}, i % 3 == 0 ? 6.0 : 0.7, lively), {}, {tilt, up, 0.2}};
        quad.sides =
            numbers.oneIn(3) ? wander(numbers, {right, 0, tilt}, 0.3, 3) : Path(frames + 1, glm::dvec3(right, 0, tilt));
        quads_.push_back(quad);
    }
    eyes_ = numbers.oneIn(2) ? Path(frames + 1, glm::dvec3(2, -11, 8)) : wander(numbers, {2, -11, 8}, 1.0, 4);
    lights_ = numbers.oneIn(2) ? Path(frames + 1, glm::dvec3(0, 0, 9)) : wander(numbers, {0, 0, 9}, 1.0, 4);

    auto topology = std::make_shared<MeshTopology>();
    for (std::uint32_t i = 0; i < quads_.size(); ++i) {
        for (const glm::u32vec3 corner : {glm::u32vec3(0, 1, 2), glm::u32vec3(0, 2, 3)}) {
            topology->triangles.push_back(corner + 4 * i);
            topology->triangleMaterials.push_back(0);
            topology->triangleInstances.push_back(i);
        }
    }
    topology->vertexCount = 4 * quads_.size();
    topology->instanceCount = quads_.size();
    topology->textureCoordinates.resize(topology->vertexCount);
    topology_ = topology;
    for (int frame = 0; frame <= frames; ++frame)
        for (const glm::dvec3& corner : corners(frame)) bounds_.add(corner);
    materials_.front().doubleSided = numbers.oneIn(2);
}

glm::dvec3 EventfulScene::at(const Path& path, double seconds) {
    const double time = std::clamp(seconds, 0.0, static_cast<double>(frames));
    const auto frame = std::min(static_cast<std::size_t>(time), path.size() - 2);
    // A static object has the same position to the last bit.
    if (path[frame] == path[frame + 1]) return path[frame];
    return glm::mix(path[frame], path[frame + 1], time - static_cast<double>(frame));
}

std::vector<glm::dvec3> EventfulScene::corners(double seconds) const {
    std::vector<glm::dvec3> all;
    for (const Quad& quad : quads_) {
        const glm::dvec3 centre = at(quad.centres, seconds), side = at(quad.sides, seconds);
        all.insert(all.end(), {centre - side - quad.up, centre + side - quad.up, centre + side + quad.up,
                               centre - side + quad.up});
    }
    return all;
}

MotionMesh EventfulScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh;
    mesh.topology = topology_;
    mesh.positionsOpen = corners(openSeconds);
    mesh.positionsClose = corners(closeSeconds);
    mesh.normalsOpen.assign(mesh.positionsOpen.size(), glm::vec3(0, 0, 1));
    mesh.normalsClose = mesh.normalsOpen;
    return mesh;
}

CameraPose EventfulScene::camera(std::size_t, double seconds) const {
    CameraPose pose = lookAt(eyes_.front(), {0, 0, 1}, {0, 0, 1}, 0.7, 0.01);
    pose.eye = at(eyes_, seconds);
    return pose;
}

LightPose EventfulScene::light(double seconds) const {
    LightPose pose;
    pose.kind = directional_ ? LightKind::Directional : LightKind::Spot;
    pose.position = at(lights_, seconds);
    pose.outerConeAngle = 0.6;
    return pose;
}

}  // namespace timeshade
