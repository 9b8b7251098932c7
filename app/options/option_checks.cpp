#include "options/option_checks.h"

#include "plan/frame_request.h"
#include "scene_catalogue.h"

namespace timeshade {

void declareSamples(CLI::App& app, int& samplesPerPixel) {
    app.add_option("--spp", samplesPerPixel, "camera samples per pixel, one per stratum of the shutter")
        ->check(numberFrom(1, maximumSamplesPerPixel))
        ->capture_default_str()
        ->multi_option_policy(lastWins);
}

CLI::Validator mapSizeText() {
    return CLI::Validator(
        [](const std::string& text) {
            return MapSize::of(text)
                       ? std::string{}
                       : fmt::format("'{}' given, expected a whole number or WIDTHxHEIGHT, each from {} to {}", text,
                                     minimumMapSide, maximumMapSide);
        },
        fmt::format("{0} to {1}, or as 1024x768", minimumMapSide, maximumMapSide));
}

void declareMapSize(CLI::App& app, MapSize& mapSize, const std::string& help) {
    app.add_option_function<std::string>(
           "--map", [&mapSize](const std::string& text) { mapSize = *MapSize::of(text); }, help)
        ->check(mapSizeText())
        ->default_str(mapSize.text())
        ->multi_option_policy(lastWins);
}

CLI::Option* declareScene(CLI::App& app, std::string& scene) {
    std::string names;
    for (const BuiltInScene& known : builtInScenes()) names += known.name + ", ";
    return app.add_option("scene,--scene", scene, names + "or a .gltf or .glb file")->multi_option_policy(lastWins);
}

}  // namespace timeshade
