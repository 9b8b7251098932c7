#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"
#include "window/moment.h"
#include "window/orbit_camera.h"

namespace timeshade {

/// A view that the user saved; settings files and undo know it.
struct SavedView {
    std::string name;
    OrbitCamera camera;
};

/// The camera: one of the scene's own, which the request names, or one that the user moves.
struct CameraControl {
    std::optional<OrbitCamera> orbit;  ///< while the camera is not the scene's own
    std::vector<SavedView> savedViews;

    /// World space, as the shutter opens.
    CameraPose pose(const Scene& scene, const Moment& moment) const;
    /// The user's camera; starts from where the scene's is.
    OrbitCamera& take(const Scene& scene, const Moment& moment);
    void useSceneCamera(Moment& moment, std::size_t index);
    /// `name`: empty for "View 3".
    void save(const Scene& scene, const Moment& moment, const std::string& name = {});
};

}  // namespace timeshade
