#include "light_text.h"

#include <fmt/format.h>

namespace timeshade {

const char* nameOf(ToneMap toneMap) {
    constexpr const char* names[] = {"filmic", "reinhard", "linear"};
    return names[static_cast<int>(toneMap)];
}

const char* nameOf(GroundChoice choice) {
    constexpr const char* names[] = {"auto", "on", "off"};
    return names[static_cast<int>(choice)];
}

void addLightWords(const FrameOptions& options, std::vector<std::pair<std::string, std::string>>& words) {
    const auto add = [&](const char* key, const std::string& value) { words.emplace_back(key, value); };
    const LightChange& light = options.light;
    if (!options.lightName.empty()) add("light", options.lightName);
    if (light.direction)
        add("light-direction", fmt::format("{},{}", light.direction->azimuth, light.direction->elevation));
    if (light.distance) add("light-distance", fmt::format("{}", *light.distance));
    if (light.cone) add("light-cone", fmt::format("{}", *light.cone));
    if (light.intensity != 1.0) add("light-intensity", fmt::format("{}", light.intensity));
    if (light.move != glm::dvec3(0.0))
        add("light-move", fmt::format("{},{},{}", light.move.x, light.move.y, light.move.z));
    if (light.turn != 0.0 || light.rise != 0.0)
        add("light-turn",
            light.rise == 0.0 ? fmt::format("{}", light.turn) : fmt::format("{},{}", light.turn, light.rise));
    const GroundSettings& ground = options.ground;
    if (ground.choice != GroundChoice::Auto) add("ground", nameOf(ground.choice));
    if (ground.height) add("ground-height", fmt::format("{}", *ground.height));
    if (ground.size) add("ground-size", fmt::format("{}", *ground.size));
    if (options.look.exposure != 0.0) add("exposure", fmt::format("{}", options.look.exposure));
    if (options.look.toneMap != ToneMap::Filmic) add("tone-map", nameOf(options.look.toneMap));
}

bool isNumberOfLight(const std::string& key) {
    for (const char* name :
         {"light-distance", "light-cone", "light-intensity", "ground-height", "ground-size", "exposure"})
        if (key == name) return true;
    return false;
}

std::string inWords(const LightChange& change) {
    std::string words;
    const auto add = [&](const std::string& part) { words += (words.empty() ? "" : ", ") + part; };
    if (change.direction)
        add(fmt::format("from azimuth {:.4g}, elevation {:.4g} degrees", change.direction->azimuth,
                        change.direction->elevation));
    if (change.distance) add(fmt::format("{:.4g} from the scene's centre", *change.distance));
    if (change.cone) add(fmt::format("a cone of {:.4g} degrees", *change.cone));
    if (change.intensity != 1.0) add(fmt::format("{:.4g} times as strong", change.intensity));
    if (change.move != glm::dvec3(0.0))
        add(fmt::format("moves by ({:.4g}, {:.4g}, {:.4g}) a frame", change.move.x, change.move.y, change.move.z));
    if (change.turn != 0.0) add(fmt::format("turns by {:.4g} degrees a frame", change.turn));
    if (change.rise != 0.0) add(fmt::format("rises by {:.4g} degrees a frame", change.rise));
    return words;
}

std::string inWords(const DisplayLook& look) {
    if (look == DisplayLook{}) return "";
    return fmt::format("exposure {:+.4g} stops, tone map {}", look.exposure, nameOf(look.toneMap));
}

}  // namespace timeshade
