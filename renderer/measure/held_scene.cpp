#include "measure/held_scene.h"

namespace timeshade {

HeldScene::HeldScene(const Scene& scene, Held held, double seconds, std::vector<bool> nonTranslating)
    : scene_(scene), held_(held), seconds_(seconds) {
    if (!held_.deformation) return;
    const MotionMesh mesh = scene.motionMesh(seconds, seconds);
    heldVertices_.assign(mesh.topology->vertexCount, false);
    for (std::size_t i = 0; i < mesh.topology->triangles.size(); ++i) {
        if (!nonTranslating[mesh.topology->triangleInstances[i]]) continue;
        const glm::u32vec3 corners = mesh.topology->triangles[i];
        for (int c = 0; c < 3; ++c) heldVertices_[corners[c]] = true;
    }
}

MotionMesh HeldScene::motionMesh(double openSeconds, double closeSeconds) const {
    if (held_.objects) return scene_.motionMesh(seconds_, seconds_);
    MotionMesh mesh = scene_.motionMesh(openSeconds, closeSeconds);
    if (!held_.deformation) return mesh;
    const MotionMesh held = scene_.motionMesh(seconds_, seconds_);
    for (std::size_t i = 0; i < heldVertices_.size(); ++i) {
        if (!heldVertices_[i]) continue;
        mesh.positionsOpen[i] = mesh.positionsClose[i] = held.positionsOpen[i];
        mesh.normalsOpen[i] = mesh.normalsClose[i] = held.normalsOpen[i];
    }
    return mesh;
}

}  // namespace timeshade
