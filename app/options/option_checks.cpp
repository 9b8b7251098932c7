#include "options/option_checks.h"

#include "plan/frame_request.h"
#include "scene_catalogue.h"

namespace timeshade {

void declareSamples(CLI::App& app, int& samplesPerPixel) {
    app.add_option("--spp", samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(numberFrom(1, maximumSamplesPerPixel))
        ->multi_option_policy(lastWins);
}

void declareMapSize(CLI::App& app, int& mapSize, const std::string& help) {
    app.add_option("--map", mapSize, help)
        ->check(numberFrom(minimumMapSize, maximumMapSize))
        ->multi_option_policy(lastWins);
}

CLI::Option* declareScene(CLI::App& app, std::string& scene) {
    std::string names;
    for (const BuiltInScene& known : builtInScenes()) names += known.name + ", ";
    return app.add_option("scene,--scene", scene, names + "or a .gltf or .glb file")->multi_option_policy(lastWins);
}

}  // namespace timeshade
