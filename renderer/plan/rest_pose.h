#pragma once

#include <mutex>
#include <optional>

#include "scene/motion_mesh.h"
#include "scene/scene.h"

namespace timeshade {

/// A scene's mesh at one fixed instant (0 s), for facts that no frame changes: whichever frame is drawn first, they are
/// the same. Made when it is first needed, once.
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
