#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scene/loading.h"
#include "scene/scene.h"
#include "scenes/scene_recipe.h"

namespace timeshade {

struct BuiltInScene {
    std::string name;
    std::string summary;
    bool computed = false;  ///< from settings, instead of a file
};

/// Settings as on the command line: "cubes.count" and "500".
using SettingTexts = std::vector<std::pair<std::string, std::string>>;

/// What of a file is shown. Computed scenes and cases have neither clips nor lights to choose from, and a ground of
/// their own.
struct SceneChoice {
    std::string clip;   ///< name of an animation; empty for the first
    std::string light;  ///< as GltfOptions::light; empty for the usual one
    GroundSettings ground;
    bool operator==(const SceneChoice&) const = default;
};

/// The scenes that come with the program: files under assets/scenes, read like any other, and the computed ones.
const std::vector<BuiltInScene>& builtInScenes();

/// The analytic cases that have a picture, named case:NAME. Made, not read from files.
const std::vector<BuiltInScene>& caseScenes();

/// What stands after "case:" in the name of a scene; null for any other scene.
std::optional<std::string> caseNameIn(const std::string& nameOrPath);

/// Names of the first look at the program, and what `measure` takes where no scene is named: those that are files.
std::vector<std::string> showcase();

/// The recipe of a computed scene with those of the settings that are its own; null for any other scene.
std::unique_ptr<SceneRecipe> recipeFor(const std::string& name, const SettingTexts& settings);

/// Loads or computes a built-in scene or a case by its name, or loads a .gltf or .glb file by its path. Throws
/// UsageError for a name that is neither, Error for a file that can't be read or that has no such clip or light, and
/// for a choice that a computed scene does not have. A file that takes more than a second is told of on standard error.
std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const SceneChoice& choice,
                                 const SettingTexts& settings = {});

/// The same, and `watch` is told instead.
std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const SceneChoice& choice, const SettingTexts& settings,
                                 const LoadingWatch& watch);

/// With its usual light and ground.
inline std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const std::string& clip = {},
                                        const SettingTexts& settings = {}) {
    return openScene(nameOrPath, SceneChoice{clip, {}, {}}, settings);
}

}  // namespace timeshade
