#pragma once

#include <functional>
#include <memory>

#include "scene/scene.h"

namespace timeshade {

/// What is done to a scene's world: a point p becomes offset + scale * rotation * p, camera and light with it.
struct WorldChange {
    double scale = 1.0;        ///< > 0; near distances follow
    glm::dmat3 rotation{1.0};  ///< orthonormal, no mirror
    glm::dvec3 offset{0.0};
};

/// A scene moved, scaled and turned as a whole, played backwards, or with its mesh replaced: what must leave every
/// picture as it was, or change it in a known way. Made for checks that need no exact answer.
class ChangedScene final : public Scene {
  public:
    using MeshChange = std::function<MotionMesh(MotionMesh)>;

    explicit ChangedScene(std::shared_ptr<const Scene> scene, WorldChange world = {}, MeshChange mesh = {});
    /// Plays the time from `openSeconds` to `closeSeconds` backwards.
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
    double heldCloseSeconds(double openSeconds, double closeSeconds) const override;
    const Bounds& bounds() const override { return bounds_; }
    const std::vector<std::string>& notes() const override { return scene_->notes(); }

  private:
    glm::dvec3 moved(const glm::dvec3& point) const { return world_.offset + world_.scale * (world_.rotation * point); }

    std::shared_ptr<const Scene> scene_;
    WorldChange world_;
    MeshChange meshChange_;
    bool reversed_ = false;
    double mirror_ = 0.0;  ///< seconds; s is played at mirror - s
    Bounds bounds_;
};

// Changes of a mesh that leave its surface as it is.

/// Each triangle begins with its second corner.
MotionMesh withCornersTurned(MotionMesh mesh);
/// Each triangle becomes four, cut at the middles of its edges.
MotionMesh subdivided(MotionMesh mesh);
/// Two triangles in a row that make up a parallelogram, at both ends and so all the time, are cut along its other
/// diagonal.
MotionMesh withDiagonalsTurned(MotionMesh mesh);
/// A quad more, of the first material, which does not move. Corners counter-clockwise.
MotionMesh withQuad(MotionMesh mesh, const glm::dvec3 (&corners)[4]);

}  // namespace timeshade
