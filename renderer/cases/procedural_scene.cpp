#include "cases/procedural_scene.h"

#include <utility>

namespace timeshade {

MovingQuad slidingQuad(glm::dvec3 a, glm::dvec3 b, double halfX, double lowY, double highY) {
    const glm::dvec3 corners[4] = {{-halfX, lowY, 0.0}, {halfX, lowY, 0.0}, {halfX, highY, 0.0}, {-halfX, highY, 0.0}};
    MovingQuad quad{};
    for (int i = 0; i < 4; ++i) {
        quad.open[i] = a + corners[i];
        quad.close[i] = b + corners[i];
    }
    return quad;
}

void ProceduralScene::finish(std::string name) {
    name_ = std::move(name);
    if (overview) cameras_ = {{"receiver"}, {"overview"}};
    auto topology = std::make_shared<MeshTopology>();
    for (std::uint32_t i = 0; i < quads.size(); ++i) {
        for (const glm::u32vec3 corner : {glm::u32vec3(0, 1, 2), glm::u32vec3(0, 2, 3)}) {
            topology->triangles.push_back(corner + 4 * i);
            topology->triangleMaterials.push_back(0);
            topology->triangleInstances.push_back(i);
        }
        for (int c = 0; c < 4; ++c) {
            bounds_.add(quads[i].open[c]);
            bounds_.add(quads[i].close[c]);
        }
    }
    for (std::uint32_t i = 0; i < triangles.size(); ++i) {
        const auto first = static_cast<std::uint32_t>(4 * quads.size()) + 3 * i;
        topology->triangles.push_back(glm::u32vec3(first, first + 1, first + 2));
        topology->triangleMaterials.push_back(0);
        topology->triangleInstances.push_back(static_cast<std::uint32_t>(quads.size()) + i);
        for (int c = 0; c < 3; ++c) {
            bounds_.add(triangles[i].open[c]);
            bounds_.add(triangles[i].close[c]);
        }
    }
    topology->vertexCount = 4 * quads.size() + 3 * triangles.size();
    topology->instanceCount = quads.size() + triangles.size();
    topology->textureCoordinates.resize(topology->vertexCount);
    topology_ = topology;
}

FrameRequest ProceduralScene::request(int width, int height, int samplesPerPixel, const MapSize& mapSize,
                                      std::uint32_t seed) {
    FrameRequest request;
    request.width = width;
    request.height = height;
    request.samplesPerPixel = samplesPerPixel;
    request.mapSize = mapSize;
    request.seed = seed;
    request.shutter = {1.0, 1.0, ShutterPosition::Start};
    return request;
}

CameraPose ProceduralScene::camera(std::size_t index, double seconds) const {
    if (overview && index == 1) return *overview;
    CameraPose pose = cameraOpen;
    pose.eye = glm::mix(cameraOpen.eye, cameraClose.eye, seconds);
    if (seconds >= 0.5) pose.axes = cameraClose.axes;
    return pose;
}

LightPose ProceduralScene::light(double seconds) const {
    LightPose pose = lightOpen;
    pose.position = glm::mix(lightOpen.position, lightClose.position, seconds);
    return pose;
}

MotionMesh ProceduralScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh;
    mesh.topology = topology_;
    const auto add = [&](const glm::dvec3* open, const glm::dvec3* close, int corners) {
        // Normals are used by shading only; a triangle without area gets an arbitrary one.
        const auto normal = [](const glm::dvec3* c) {
            const glm::dvec3 n = glm::cross(c[1] - c[0], c[2] - c[0]);
            return glm::length(n) > 0.0 ? glm::vec3(glm::normalize(n)) : glm::vec3(0.0f, 0.0f, 1.0f);
        };
        for (int c = 0; c < corners; ++c) {
            mesh.positionsOpen.push_back(glm::mix(open[c], close[c], openSeconds));
            mesh.positionsClose.push_back(glm::mix(open[c], close[c], closeSeconds));
            mesh.normalsOpen.push_back(normal(open));
            mesh.normalsClose.push_back(normal(close));
        }
    };
    for (const MovingQuad& quad : quads) add(quad.open, quad.close, 4);
    for (const MovingCorners& triangle : triangles) add(triangle.open, triangle.close, 3);
    return mesh;
}

}  // namespace timeshade
