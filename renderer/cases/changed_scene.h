#pragma once

#include <functional>
#include <memory>

#include "scene/scene.h"

namespace timeshade {

/// A similarity transform of a scene's world, camera and light included: p becomes offset + scale * rotation * p.
struct WorldChange {
    double scale = 1.0;        ///< > 0; also applied to near distances
    glm::dmat3 rotation{1.0};  ///< orthonormal, not mirroring
    glm::dvec3 offset{0.0};
};

/// A scene that is translated, scaled and rotated as a whole, played backwards, or has its mesh replaced. For
/// metamorphic tests: these changes must leave every picture unchanged or change it in a known way.
class ChangedScene final : public Scene {
  public:
    using MeshChange = std::function<MotionMesh(MotionMesh)>;

    explicit ChangedScene(std::shared_ptr<const Scene> scene, WorldChange world = {}, MeshChange mesh = {});
    /// Plays the interval from `openSeconds` to `closeSeconds` backwards.
    void reverse(double openSeconds, double closeSeconds);

    const std::string& name() const override { return scene_->name(); }
    double duration() const override { return scene_->duration(); }
    const SceneDefaults& defaults() const override { return scene_->defaults(); }
    const std::vector<Material>& materials() const override { return scene_->materials(); }
    const std::vector<Image>& images() const override { return scene_->images(); }
    const std::vector<CameraBookmark>& cameras() const override { return scene_->cameras(); }
    CameraPose camera(std::size_t index, double seconds) const override;
    LightPose light(double seconds) const override;
    MotionMesh motionMesh(double openSeconds, double closeSeconds) const override;
    bool loops() const override { return scene_->loops(); }
    ShutterEnds<CameraPose> cameraEnds(std::size_t index, double openSeconds, double closeSeconds) const override;
    ShutterEnds<LightPose> lightEnds(double openSeconds, double closeSeconds) const override;
    const Bounds& bounds() const override { return bounds_; }
    const std::vector<std::string>& notes() const override { return scene_->notes(); }

  private:
    CameraPose moved(CameraPose pose) const;
    LightPose moved(LightPose pose) const;
    glm::dvec3 moved(const glm::dvec3& point) const { return world_.offset + world_.scale * (world_.rotation * point); }

    std::shared_ptr<const Scene> scene_;
    WorldChange world_;
    MeshChange meshChange_;
    bool reversed_ = false;
    double mirror_ = 0.0;  ///< seconds; time s shows the scene at mirror - s
    Bounds bounds_;
};

// Changes of a mesh that leave its surface as it is.

/// Rotates the order of corners: each triangle begins with its second corner.
MotionMesh withCornersTurned(MotionMesh mesh);
/// Splits each triangle into four at the midpoints of its edges.
MotionMesh subdivided(MotionMesh mesh);
/// Replaces the diagonal of two consecutive triangles that form a parallelogram at both ends of the shutter.
MotionMesh withDiagonalsTurned(MotionMesh mesh);
/// Adds a static quad of the first material. Corners counter-clockwise.
MotionMesh withQuad(MotionMesh mesh, const glm::dvec3 (&corners)[4]);

}  // namespace timeshade
