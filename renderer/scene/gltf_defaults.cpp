#include "scene/gltf_defaults.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

namespace timeshade::gltf {

namespace {

using Json = nlohmann::json;

/// The number under the key if it is in [low, high]. Otherwise nothing, with a note if the key is present.
std::optional<double> number(const Json& extras, const char* key, double low, double high,
                             std::vector<std::string>& notes) {
    const auto found = extras.find(key);
    if (found == extras.end()) return std::nullopt;
    const double value = found->is_number() ? found->get<double>() : std::numeric_limits<double>::quiet_NaN();
    if (value >= low && value <= high) return value;
    notes.push_back(fmt::format("extras.timeshade.{} is not a number from {} to {} and is ignored", key, low, high));
    return std::nullopt;
}

}  // namespace

SceneDefaults readDefaults(const Json& root, int scene, double duration, std::vector<std::string>& notes) {
    SceneDefaults defaults;
    Json extras;
    if (scene >= 0) {
        const Json::json_pointer place(fmt::format("/scenes/{}/extras/timeshade", scene));
        if (root.contains(place)) extras = root[place];
    }
    if (!extras.is_null() && !extras.is_object()) notes.push_back("extras.timeshade is not an object and is ignored");
    if (!extras.is_object()) extras = Json::object();

    defaults.framesPerSecond = number(extras, "fps", 1e-3, 1e6, notes).value_or(defaults.framesPerSecond);
    defaults.shutterLength = number(extras, "shutter", 0.0, 1e3, notes).value_or(defaults.shutterLength);
    const double third = std::min(std::round(duration / 3.0 * defaults.framesPerSecond), 1e9);
    defaults.frame = number(extras, "frame", -1e9, 1e9, notes).value_or(third);
    return defaults;
}

}  // namespace timeshade::gltf
