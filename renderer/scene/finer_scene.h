#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "scene/edge_split.h"
#include "scene/scene.h"

namespace timeshade {

/// A scene whose moving things have more triangles: their longest edges are divided in the middle, so that the whole
/// has as many triangles as are wanted, or at most three more. New vertices lie on a cubic curve between the old ones
/// that meets their normals (as the edges of PN triangles, Vlachos et al. 2001), at both ends of the shutter; closed
/// surfaces stay closed. Where an edge is a crease they lie on the edge. Each triangle becomes four at most.
class FinerScene final : public Scene {
  public:
    /// Of the scene with that name and those parameters; both stand in its reports.
    FinerScene(std::unique_ptr<const Scene> scene, std::size_t triangles, std::string name,
               std::vector<SceneParameter> parameters);

    const std::string& name() const override { return name_; }
    double duration() const override { return scene_->duration(); }
    bool loops() const override { return scene_->loops(); }
    const SceneDefaults& defaults() const override { return scene_->defaults(); }
    const std::vector<Material>& materials() const override { return scene_->materials(); }
    const std::vector<Image>& images() const override { return scene_->images(); }
    const std::vector<CameraBookmark>& cameras() const override { return scene_->cameras(); }
    CameraPose camera(std::size_t index, double seconds) const override { return scene_->camera(index, seconds); }
    LightPose light(double seconds) const override { return scene_->light(seconds); }
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    ShutterEnds<CameraPose> cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const override {
        return scene_->cameraEnds(index, openSeconds, closeSeconds);
    }
    ShutterEnds<LightPose> lightEnds(double openSeconds, double closeSeconds) const override {
        return scene_->lightEnds(openSeconds, closeSeconds);
    }
    /// Old vertices are in front and as they were.
    InnerMotion innerMotion(double openSeconds, double closeSeconds) const override {
        return scene_->innerMotion(openSeconds, closeSeconds);
    }
    const Bounds& bounds() const override { return bounds_; }
    const std::vector<std::string>& notes() const override { return scene_->notes(); }
    const std::vector<SceneParameter>& parameters() const override { return parameters_; }
    /// That of the scene, with the name and the parameters.
    std::string contentDigest() const override;

  private:
    std::unique_ptr<const Scene> scene_;
    std::string name_;
    std::vector<SceneParameter> parameters_;
    Bounds bounds_;
    EdgeSplits splits_;
    mutable std::mutex mutex_;
    mutable std::map<std::shared_ptr<const MeshTopology>, std::shared_ptr<const MeshTopology>> topologies_;
};

}  // namespace timeshade
