#include "scene_catalogue.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "cases/closed_form_cases.h"
#include "core/data_folder.h"
#include "core/error.h"
#include "loading_line.h"
#include "scene/gltf_scene.h"
#include "scene_memory.h"

namespace timeshade {

namespace {
std::filesystem::path sceneDirectory() {
    if (const char* folder = std::getenv("TIMESHADE_SCENES")) return folder;
    return dataFolder() / "assets" / "scenes";
}
}  // namespace

const std::vector<BuiltInScene>& builtInScenes() {
    static const std::vector<BuiltInScene> scenes = [] {
        std::vector<BuiltInScene> all{
            {"chess", "a game in motion: a knight leaps, a queen slides, a captured rook rolls"},
            {"octopus", "eight arms that curl over sand, each at its own speed: deforming casters, crossing shadows"},
            {"pillars", "static pillars under a light that rises within the shutter"},
        };
        for (const RecipeDescription& recipe : recipeDescriptions()) all.push_back({recipe.name, recipe.summary, true});
        return all;
    }();
    return scenes;
}

const std::vector<BuiltInScene>& caseScenes() {
    static const std::vector<BuiltInScene> scenes = [] {
        std::vector<BuiltInScene> all;
        for (const ClosedFormCase& c : closedFormCases())
            if (c.scene)
                all.push_back(
                    {"case:" + c.name, fmt::format("{}; lit {:.7g}; hard for: {}", c.motion, c.exact, c.breaks)});
        return all;
    }();
    return scenes;
}

std::vector<std::string> showcase() {
    std::vector<std::string> names;
    for (const BuiltInScene& scene : builtInScenes())
        if (!scene.computed) names.push_back(scene.name);
    return names;
}

std::unique_ptr<SceneRecipe> recipeFor(const std::string& name, const SettingTexts& settings) {
    std::unique_ptr<SceneRecipe> recipe = makeRecipe(name);
    if (!recipe) return nullptr;
    const std::string prefix = name + ".";
    for (const auto& [key, value] : settings)
        if (key.starts_with(prefix)) setFromText(*recipe, key.substr(prefix.size()), value);
    return recipe;
}

std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const std::string& clip, const SettingTexts& settings) {
    LoadingLine line(nameOrPath);
    return openScene(nameOrPath, clip, settings, [&line](const LoadingStep& step) { line.show(step); });
}

std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const std::string& clip, const SettingTexts& settings,
                                 const LoadingWatch& watch) {
    if (nameOrPath.starts_with("case:")) {
        const ClosedFormCase& c = closedFormCase(nameOrPath.substr(5));
        if (!c.scene)
            throw UsageError(
                fmt::format("scene '{}': this case has no picture; `timeshade cases` evaluates it", nameOrPath));
        return std::make_unique<ProceduralScene>(*c.scene);
    }
    if (const std::unique_ptr<SceneRecipe> recipe = recipeFor(nameOrPath, settings)) {
        if (!clip.empty())
            throw Error(fmt::format("--clip {}: scene {} is computed and has no clips", clip, nameOrPath));
        return recipe->make();
    }
    GltfOptions options;
    options.clip = clip;
    options.memoryLimit = sceneMemoryLimit();
    options.watch = watch;
    std::string known;
    for (const BuiltInScene& scene : builtInScenes()) {
        if (scene.name == nameOrPath) return loadGltf(sceneDirectory() / (scene.name + ".glb"), options);
        known += scene.name + ", ";
    }
    const bool isPath =
        nameOrPath.ends_with(".gltf") || nameOrPath.ends_with(".glb") || nameOrPath.find('/') != std::string::npos;
    if (!isPath)
        throw UsageError(fmt::format(
            "scene '{}': no such scene; expected {}case:NAME or a path to a .gltf or .glb file", nameOrPath, known));
    return loadGltf(nameOrPath, options);
}

}  // namespace timeshade
