#include "scene_catalogue.h"

#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/gltf_scene.h"

namespace timeshade {

namespace {
std::filesystem::path sceneDirectory() {
    if (const char* folder = std::getenv("TIMESHADE_SCENES")) return folder;
    return std::filesystem::path(TIMESHADE_SOURCE_DIRECTORY) / "assets" / "scenes";
}
} // namespace

const std::vector<BuiltInScene>& builtInScenes() {
    static const std::vector<BuiltInScene> scenes{
        {"chess", "a game in motion: a knight leaps, a queen slides, a captured rook rolls"},
        {"octopus", "eight arms that curl over sand, each at its own speed: deforming casters, crossing shadows"},
        {"pillars", "still pillars under a light that rises within the shutter"},
    };
    return scenes;
}

std::unique_ptr<Scene> openScene(const std::string& nameOrPath, const std::string& clip) {
    GltfOptions options;
    options.clip = clip;
    std::string known;
    for (const BuiltInScene& scene : builtInScenes()) {
        if (scene.name == nameOrPath) return loadGltf(sceneDirectory() / (scene.name + ".glb"), options);
        known += scene.name + ", ";
    }
    const bool isPath = nameOrPath.ends_with(".gltf") || nameOrPath.ends_with(".glb") || nameOrPath.find('/') != std::string::npos;
    if (!isPath) throw UsageError(fmt::format("scene '{}': no such scene; expected {}or a path to a .gltf or .glb file", nameOrPath, known));
    return loadGltf(nameOrPath, options);
}

} // namespace timeshade
