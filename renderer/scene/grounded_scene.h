#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "scene/ground.h"
#include "scene/scene.h"

namespace timeshade {

/// The scene of a file, with a still square of ground below it where the settings ask for one: one more mesh, of a
/// material of its own, behind all others. A camera that is fitted to the scene's things is fitted to their shadow,
/// too. Without a ground it is the scene, unchanged.
class GroundedScene final : public Scene {
  public:
    GroundedScene(std::shared_ptr<const Scene> scene, const GroundSettings& settings);

    /// The scene without a ground.
    const Scene& bare() const { return *scene_; }
    /// The same file's scene with other settings; what has been found out about it is kept.
    GroundedScene(const GroundedScene& other, const GroundSettings& settings);

    const std::string& name() const override { return scene_->name(); }
    double duration() const override { return scene_->duration(); }
    bool loops() const override { return scene_->loops(); }
    const SceneDefaults& defaults() const override { return scene_->defaults(); }
    const std::vector<Material>& materials() const override { return square_ ? materials_ : scene_->materials(); }
    const std::vector<Image>& images() const override { return scene_->images(); }
    const std::vector<CameraBookmark>& cameras() const override { return scene_->cameras(); }
    CameraPose camera(std::size_t index, double seconds) const override {
        return fittedCamera_ ? *fittedCamera_ : scene_->camera(index, seconds);
    }
    LightPose light(double seconds) const override { return scene_->light(seconds); }
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    ShutterEnds<CameraPose> cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const override {
        if (fittedCamera_) return {*fittedCamera_, *fittedCamera_};
        return scene_->cameraEnds(index, openSeconds, closeSeconds);
    }
    ShutterEnds<LightPose> lightEnds(double openSeconds, double closeSeconds) const override {
        return scene_->lightEnds(openSeconds, closeSeconds);
    }
    InnerMotion innerMotion(double openSeconds, double closeSeconds) const override {
        return scene_->innerMotion(openSeconds, closeSeconds);
    }
    const Bounds& bounds() const override { return scene_->bounds(); }
    const std::vector<std::string>& clips() const override { return scene_->clips(); }
    std::size_t clip() const override { return scene_->clip(); }
    const std::vector<std::string>& lights() const override { return scene_->lights(); }
    std::size_t chosenLight() const override { return scene_->chosenLight(); }
    const std::optional<GroundSquare>& ground() const override { return square_; }
    const std::vector<std::string>& notes() const override { return notes_; }
    const std::vector<SceneParameter>& parameters() const override { return scene_->parameters(); }
    std::string contentDigest() const override;

  private:
    /// What is fitted to the scene alone, once it has been asked for.
    struct Fit {
        std::optional<bool> lacksGround;
        std::optional<GroundSquare> square;
    };
    void lay(const GroundSettings& settings);
    std::shared_ptr<const MeshTopology> topologyWithSquare(const std::shared_ptr<const MeshTopology>& bare) const;

    std::shared_ptr<const Scene> scene_;
    Fit fit_;
    std::optional<GroundSquare> square_;
    std::optional<CameraPose> fittedCamera_;  ///< the only one, where the file has none
    std::vector<Material> materials_;
    std::vector<std::string> notes_;
    mutable std::mutex mutex_;
    mutable std::map<std::shared_ptr<const MeshTopology>, std::shared_ptr<const MeshTopology>> topologies_;
};

}  // namespace timeshade
