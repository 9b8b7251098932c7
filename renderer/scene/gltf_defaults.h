#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace timeshade::gltf {

/// The defaults that scene number `scene` (-1: none) declares in `extras.timeshade`: {"frame", "fps", "shutter"}, each
/// optional. Invalid values are replaced, with a note. Without a "frame", an animated file starts a third into its
/// clip, where motion is likely. duration: seconds, 0 if nothing moves.
SceneDefaults readDefaults(const nlohmann::json& root, int scene, double duration, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
