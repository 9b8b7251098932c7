#pragma once

#include <mutex>
#include <optional>

#include "scene/motion_mesh.h"
#include "scene/scene.h"

namespace timeshade {

/// A scene's mesh at one fixed instant (0 s), for facts that must not depend on which frame is drawn first. Computed
/// once, on first use; safe to use from several threads.
class RestPose {
  public:
    /// The scene must outlive the pose.
    explicit RestPose(const Scene& scene) : scene_(scene) {}
    const MotionMesh& mesh() const;

  private:
    const Scene& scene_;
    mutable std::once_flag made_;
    mutable std::optional<MotionMesh> mesh_;
};

}  // namespace timeshade
