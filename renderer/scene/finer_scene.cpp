#include "scene/finer_scene.h"

#include <utility>

namespace timeshade {

namespace {

/// A frame in the middle of the clip, in which what moves has moved.
MotionMesh someFrame(const Scene& scene) {
    const double rate = scene.defaults().framesPerSecond, frame = scene.defaults().frame;
    return scene.motionMesh(frame / rate, (frame + 1.0) / rate);
}

}  // namespace

FinerScene::FinerScene(std::unique_ptr<const Scene> scene, std::size_t triangles, std::string name,
                       std::vector<SceneParameter> parameters)
    : scene_(std::move(scene)),
      name_(std::move(name)),
      parameters_(std::move(parameters)),
      bounds_(scene_->bounds()),
      splits_(someFrame(*scene_), triangles) {
    // Curves between vertices swell a little beyond them.
    const glm::dvec3 margin(0.01 * bounds_.diagonal());
    bounds_.add(bounds_.low - margin);
    bounds_.add(bounds_.high + margin);
}

std::string FinerScene::contentDigest() const { return Scene::contentDigest() + " of " + scene_->contentDigest(); }

MotionMesh FinerScene::motionMesh(double openSeconds, double closeSeconds) const {
    MotionMesh mesh = scene_->motionMesh(openSeconds, closeSeconds);
    splits_.append(mesh.positionsOpen, mesh.normalsOpen);
    splits_.append(mesh.positionsClose, mesh.normalsClose);
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const MeshTopology>& known = topologies_[mesh.topology];
    if (!known) known = std::make_shared<const MeshTopology>(splits_.divided(*mesh.topology));
    mesh.topology = known;
    return mesh;
}

}  // namespace timeshade
