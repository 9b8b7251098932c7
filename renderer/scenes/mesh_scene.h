#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/clip_clock.h"
#include "scene/scene.h"
#include "scenes/flesh.h"
#include "scenes/rigid_pose.h"
#include "scenes/shape.h"

namespace timeshade {

/// One shape in a scene. Time is in seconds from 0 to the scene's duration; the poses at both ends must be equal.
struct MeshInstance {
    std::shared_ptr<const Shape> shape;
    std::uint32_t material = 0;
    RigidPose pose;  ///< of a static instance
    /// Of a moving instance; empty otherwise. Called from several threads at once.
    std::function<RigidPose(double seconds)> motion;
    /// Of one that bends, in the world, instead of both; empty otherwise.
    std::shared_ptr<const Flesh> flesh;

    bool moves() const { return motion || flesh; }
};

/// The parts of a computed scene. Cameras and the light, too, must be equal at both ends of the duration.
struct SceneParts {
    std::string name;
    double duration = 0.0;  ///< seconds after which everything repeats; 0 if nothing moves
    SceneDefaults defaults;
    std::vector<Material> materials;
    std::vector<Image> images;
    std::vector<MeshInstance> instances;
    std::vector<std::pair<std::string, std::function<CameraPose(double seconds)>>> cameras;
    std::function<LightPose(double seconds)> light;
    Bounds bounds;  ///< must contain everything at all times
    std::vector<SceneParameter> parameters;
};

/// A scene of shapes that move, or bend, as functions of time.
class MeshScene final : public Scene {
  public:
    /// `parts` must have at least one material, one instance and one camera, and a light (checked).
    explicit MeshScene(SceneParts parts);

    const std::string& name() const override { return parts_.name; }
    double duration() const override { return parts_.duration; }
    const SceneDefaults& defaults() const override { return parts_.defaults; }
    const std::vector<Material>& materials() const override { return parts_.materials; }
    const std::vector<Image>& images() const override { return parts_.images; }
    const std::vector<CameraBookmark>& cameras() const override { return cameras_; }
    CameraPose camera(std::size_t index, double seconds) const override {
        return parts_.cameras.at(index).second(clock_.clipTime(seconds));
    }
    LightPose light(double seconds) const override { return parts_.light(clock_.clipTime(seconds)); }
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    InnerMotion innerMotion(double openSeconds, double closeSeconds) const override;
    const Bounds& bounds() const override { return parts_.bounds; }
    const std::vector<std::string>& notes() const override { return notes_; }
    const std::vector<SceneParameter>& parameters() const override { return parts_.parameters; }

  private:
    SceneParts parts_;
    ClipClock clock_;
    std::vector<CameraBookmark> cameras_;
    std::vector<std::string> notes_;
    std::shared_ptr<const MeshTopology> topology_;
    std::vector<std::size_t> firstVertices_;            ///< of each instance
    std::vector<std::vector<std::uint32_t>> extremes_;  ///< vertices of each moving instance's shape
    std::vector<std::string> things_;
};

}  // namespace timeshade
