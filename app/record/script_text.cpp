#include "record/script_text.h"

#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/check.h"
#include "core/error.h"
#include "core/json_limits.h"
#include "core/one_line.h"
#include "json_lines.h"

namespace timeshade {

namespace {

constexpr std::size_t mostParts = 1000;

std::string shown(const nlohmann::json& value) { return oneLine(value.dump()); }

/// What a part has besides settings.
const std::vector<std::string> keysOfParts{"frames", "step", "camera_to", "seam", "title", "caption"};

std::string textIn(const nlohmann::json& part, const std::string& key) {
    const nlohmann::json value = part.value(key, nlohmann::json(""));
    if (!value.is_string()) throw Error(fmt::format("\"{}\" is {}; expected a text", key, value.type_name()));
    return value.get<std::string>();
}

double numberIn(const nlohmann::json& part, const std::string& key, double otherwise, double least, double most) {
    const nlohmann::json value = part.value(key, nlohmann::json(otherwise));
    if (!value.is_number() || value.get<double>() < least || value.get<double>() > most)
        throw Error(fmt::format("\"{}\" is {}; expected a number from {:g} to {:g}", key, shown(value), least, most));
    return value.get<double>();
}

std::vector<double> seamsIn(const nlohmann::json& part) {
    nlohmann::json value = part.value("seam", nlohmann::json(0.5));
    if (!value.is_array()) value = nlohmann::json::array({value});
    std::vector<double> seams;
    for (const nlohmann::json& seam : value) {
        if (!seam.is_number() || seam.get<double>() < 0.0 || seam.get<double>() > 1.0)
            throw Error(fmt::format("\"seam\" holds {}; expected numbers from 0 to 1", shown(seam)));
        seams.push_back(seam.get<double>());
    }
    if (seams.empty()) throw Error("\"seam\" is empty; expected a number from 0 to 1 or an array of them");
    return seams;
}

PartText partOf(const nlohmann::json& json) {
    PartText part;
    part.frames = static_cast<int>(numberIn(json, "frames", 0.0, 0.0, 1e6));
    part.step = numberIn(json, "step", 1.0, 0.0, 100.0);
    part.cameraTo = textIn(json, "camera_to");
    part.seams = seamsIn(json);
    part.title = textIn(json, "title");
    part.caption = textIn(json, "caption");
    if (!json.contains("scene") || !json["scene"].is_string()) throw Error("has no \"scene\"; expected a scene's name");
    part.scene = json["scene"].get<std::string>();
    return part;
}

/// The objects of which a script consists, checked for their number and kind.
nlohmann::json partsIn(const nlohmann::json& json, const std::string& path) {
    if (!json.is_object() || !json.contains("parts") || !json["parts"].is_array() || json["parts"].empty())
        throw Error(fmt::format("{}: expected a JSON object with \"parts\", an array of at least one part", path));
    if (json["parts"].size() > mostParts)
        throw Error(fmt::format("{}: has {} parts; expected at most {}", path, json["parts"].size(), mostParts));
    for (std::size_t i = 0; i < json["parts"].size(); ++i)
        if (!json["parts"][i].is_object())
            throw Error(
                fmt::format("{}: part {} is {}; expected an object", path, i + 1, json["parts"][i].type_name()));
    if (json.contains("options") && !json["options"].is_object())
        throw Error(
            fmt::format("{}: \"options\" is {}; expected an object of settings", path, json["options"].type_name()));
    return json["parts"];
}

}  // namespace

ScriptText scriptOfJson(const std::string& text, const std::string& path) {
    const bool readable = !isNestedTooDeeply(text) && text.find('\0') == std::string::npos;
    const nlohmann::json json = readable ? nlohmann::json::parse(text, nullptr, false) : nlohmann::json();
    const nlohmann::json parts = partsIn(json, path);
    ScriptText script;
    for (const JsonPiece& options : objectsUnder(text, "options"))
        script.common = settingsOfJson(options.text, path, options.line);
    const std::vector<JsonPiece> pieces = objectsUnder(text, "parts");
    CHECK_EQ(pieces.size(), parts.size());
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const std::string place = fmt::format("{}: part {}", path, i + 1);
        try {
            script.parts.push_back(partOf(parts[i]));
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", place, error.what()));
        }
        script.parts.back().place = place;
        script.parts.back().settings = settingsOfJson(pieces[i].text, path, pieces[i].line, keysOfParts);
    }
    return script;
}

}  // namespace timeshade
