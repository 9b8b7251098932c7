#pragma once

#include <vector>

#include "scene/scene.h"

namespace timeshade {

/// What of a scene's motion is left out.
struct Held {
    bool objects = false;      ///< everything with triangles
    bool deformation = false;  ///< the instances that turn or deform, as `nonTranslating` says
    bool light = false;
    bool camera = false;
};

/// A scene some of whose motion is left out: that part stays as it is at one moment. `nonTranslating`, of the
/// topology's instances: which are held with the deformation.
class HeldScene final : public Scene {
  public:
    HeldScene(const Scene& scene, Held held, double seconds, std::vector<bool> nonTranslating);

    const std::string& name() const override { return scene_.name(); }
    double duration() const override { return scene_.duration(); }
    const SceneDefaults& defaults() const override { return scene_.defaults(); }
    const std::vector<Material>& materials() const override { return scene_.materials(); }
    const std::vector<Image>& images() const override { return scene_.images(); }
    const std::vector<CameraBookmark>& cameras() const override { return scene_.cameras(); }
    CameraPose camera(std::size_t index, double seconds) const override {
        return scene_.camera(index, held_.camera ? seconds_ : seconds);
    }
    LightPose light(double seconds) const override { return scene_.light(held_.light ? seconds_ : seconds); }
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    bool loops() const override { return scene_.loops(); }
    ShutterEnds<CameraPose> cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const override {
        if (held_.camera) return {scene_.camera(index, seconds_), scene_.camera(index, seconds_)};
        return scene_.cameraEnds(index, openSeconds, closeSeconds);
    }
    ShutterEnds<LightPose> lightEnds(double openSeconds, double closeSeconds) const override {
        if (held_.light) return {scene_.light(seconds_), scene_.light(seconds_)};
        return scene_.lightEnds(openSeconds, closeSeconds);
    }
    const Bounds& bounds() const override { return scene_.bounds(); }
    const std::vector<std::string>& notes() const override { return scene_.notes(); }

  private:
    const Scene& scene_;
    Held held_;
    double seconds_;
    std::vector<bool> heldVertices_;  ///< with the deformation
};

}  // namespace timeshade
