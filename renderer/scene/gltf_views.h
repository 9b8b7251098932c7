#pragma once

#include <string>
#include <vector>

#include "scene/node_motion.h"
#include "scene/scene.h"

namespace timeshade::gltf {

/// A camera or light that a node carries, or (node -1) one that was fitted to the scene.
struct PlacedCamera {
    int node = -1;
    CameraPose pose;  ///< eye and axes are overwritten by the node's
};
struct PlacedLight {
    int node = -1;
    bool aimed = false;  ///< a point light: it has no direction, so it looks at the scene's centre
    LightPose pose;      ///< position and axes are overwritten by the node's
    /// At rest, and what the clip drives of it: colour, intensity, range and cone.
    Light properties;
    std::vector<Track> tracks;

    /// The pose with the properties of a time. All of a shutter have those of its middle, `steps`: linear changes of
    /// intensity get their mean.
    LightPose at(const ClipInstant& instant) const;
};

struct Views {
    std::vector<CameraBookmark> names;  ///< all different, one per camera
    std::vector<PlacedCamera> cameras;  ///< never empty
    PlacedLight light;
    std::vector<std::string> lightNames;  ///< all different, one per light of the scene that can be used
    std::size_t chosenLight = 0;          ///< the number of names where the light is fitted
};

/// Cameras and the light of the shown scene, or fitted ones where the file has none. `wantedLight` as in GltfOptions;
/// throws Error where there is no such light.
Views readViews(const Model& model, const Clip& clip, const Bounds& bounds, const std::string& wantedLight,
                std::vector<std::string>& notes);

}  // namespace timeshade::gltf
