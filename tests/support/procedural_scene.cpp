#include "support/procedural_scene.h"

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

void ProceduralScene::finish() {
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
    topology->vertexCount = 4 * quads.size();
    topology->instanceCount = quads.size();
    topology->textureCoordinates.resize(topology->vertexCount);
    topology_ = topology;
}

FrameRequest ProceduralScene::request(int width, int height, int samplesPerPixel, int mapSize, std::uint32_t seed) {
    FrameRequest request;
    request.width = width;
    request.height = height;
    request.samplesPerPixel = samplesPerPixel;
    request.mapSize = mapSize;
    request.seed = seed;
    request.shutter = {1.0, 1.0, ShutterPosition::Start};
    return request;
}

CameraPose ProceduralScene::camera(std::size_t, double seconds) const {
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
    for (const MovingQuad& quad : quads) {
        const glm::vec3 normalOpen(glm::normalize(glm::cross(quad.open[1] - quad.open[0], quad.open[2] - quad.open[0])));
        const glm::vec3 normalClose(glm::normalize(glm::cross(quad.close[1] - quad.close[0], quad.close[2] - quad.close[0])));
        for (int c = 0; c < 4; ++c) {
            mesh.positionsOpen.push_back(glm::mix(quad.open[c], quad.close[c], openSeconds));
            mesh.positionsClose.push_back(glm::mix(quad.open[c], quad.close[c], closeSeconds));
            mesh.normalsOpen.push_back(normalOpen);
            mesh.normalsClose.push_back(normalClose);
        }
    }
    return mesh;
}

} // namespace timeshade
