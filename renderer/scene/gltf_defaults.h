#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "scene/scene.h"

namespace timeshade::gltf {

/// What scene number `scene` (-1: none) suggests in `extras.timeshade`: {"frame", "fps", "shutter"}, each optional.
/// A value that makes no sense is replaced, with a note. A file that moves and suggests no frame starts a third
/// into its clip, where something is likely to be happening. duration: seconds, 0 where nothing moves.
SceneDefaults readDefaults(const nlohmann::json& root, int scene, double duration, std::vector<std::string>& notes);

}  // namespace timeshade::gltf
