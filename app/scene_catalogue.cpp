#include "scene_catalogue.h"

#include <filesystem>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cases/closed_form_cases.h"
#include "core/error.h"
#include "core/nearest_word.h"
#include "core/scene_folder.h"
#include "loading_line.h"
#include "scene/gltf_scene.h"
#include "scene/grounded_scene.h"
#include "scene_memory.h"

namespace timeshade {

namespace {
const std::string casePrefix = "case:";
}

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
                    {casePrefix + c.name, fmt::format("{}; lit {:.7g}; hard for: {}", c.motion, c.exact, c.breaks)});
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

namespace {

/// Throws Error where something is chosen of a scene that is made here.
void requireNoChoice(const SceneChoice& choice, const std::string& name) {
    const std::string rest = fmt::format("scene {} is computed and has", name);
    if (!choice.clip.empty()) throw Error(fmt::format("--clip {}: {} no clips", choice.clip, rest));
    if (!choice.light.empty())
        throw Error(
            fmt::format("--light {}: {} one light; expected --light-direction and the like", choice.light, rest));
    if (choice.ground.choice == GroundChoice::On)
        throw Error(fmt::format("--ground on: {} a ground of its own; expected a .gltf or .glb file", rest));
}

std::unique_ptr<Scene> loadFile(const std::filesystem::path& path, const SceneChoice& choice,
                                const LoadingWatch& watch) {
    GltfOptions options;
    options.clip = choice.clip;
    options.light = choice.light;
    options.memoryLimit = sceneMemoryLimit();
    options.watch = watch;
    return std::make_unique<GroundedScene>(loadGltf(path, options), choice.ground);
}

}  // namespace

std::optional<std::string> caseNameIn(const std::string& nameOrPath) {
    if (!nameOrPath.starts_with(casePrefix)) return std::nullopt;
    return nameOrPath.substr(casePrefix.size());
}

std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const SceneChoice& choice,
                                 const SettingTexts& settings) {
    LoadingLine line(nameOrPath);
    return openScene(nameOrPath, choice, settings, [&line](const LoadingStep& step) { line.show(step); });
}

std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const SceneChoice& choice, const SettingTexts& settings,
                                 const LoadingWatch& watch) {
    if (const std::optional<std::string> name = caseNameIn(nameOrPath)) {
        const ClosedFormCase& c = closedFormCase(*name);
        if (!c.scene)
            throw UsageError(
                fmt::format("scene '{}': this case has no picture; `timeshade cases` evaluates it", nameOrPath));
        requireNoChoice(choice, nameOrPath);
        return std::make_unique<ProceduralScene>(*c.scene);
    }
    if (const std::unique_ptr<SceneRecipe> recipe = recipeFor(nameOrPath, settings)) {
        requireNoChoice(choice, nameOrPath);
        return recipe->make();
    }
    std::vector<std::string> known;
    for (const BuiltInScene& scene : builtInScenes()) {
        if (scene.name == nameOrPath) {
            SceneChoice own = choice;  // they have a ground of their own
            if (own.ground.choice == GroundChoice::Auto) own.ground.choice = GroundChoice::Off;
            return loadFile(sceneFolder() / (scene.name + ".glb"), own, watch);
        }
        known.push_back(scene.name);
    }
    const bool isPath =
        nameOrPath.ends_with(".gltf") || nameOrPath.ends_with(".glb") || nameOrPath.find('/') != std::string::npos;
    if (!isPath)
        throw UsageError(
            fmt::format("scene '{}': no such scene{}; expected {}, case:NAME or a path to a .gltf or .glb file",
                        nameOrPath, didYouMean(nameOrPath, known), fmt::join(known, ", ")));
    return loadFile(nameOrPath, choice, watch);
}

}  // namespace timeshade
