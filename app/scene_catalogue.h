#pragma once

#include <memory>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace timeshade {

struct BuiltInScene {
    std::string name;
    std::string summary;
};

/// The scenes that come with the program: files under assets/scenes, read like any other.
const std::vector<BuiltInScene>& builtInScenes();

/// Loads a built-in scene by its name, or a .gltf or .glb file by its path. Throws UsageError for a name that is
/// neither, Error for a file that can't be read.
std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const std::string& clip);

} // namespace timeshade
