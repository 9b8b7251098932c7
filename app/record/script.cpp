#include "record/script.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json_limits.h"
#include "options/command.h"
#include "settings_file.h"

namespace timeshade {

namespace {

/// Takes a key out of a part; the rest of it are options.
nlohmann::json taken(nlohmann::json& part, const std::string& key) {
    nlohmann::json value = part.value(key, nlohmann::json());
    part.erase(key);
    return value;
}

std::string takenText(nlohmann::json& part, const std::string& key) {
    const nlohmann::json value = taken(part, key);
    if (!value.is_null() && !value.is_string())
        throw Error(fmt::format("\"{}\" is {}; expected a text", key, value.type_name()));
    return value.is_string() ? value.get<std::string>() : "";
}

double takenNumber(nlohmann::json& part, const std::string& key, double otherwise, double least, double most) {
    const nlohmann::json value = taken(part, key);
    if (value.is_null()) return otherwise;
    if (!value.is_number() || value.get<double>() < least || value.get<double>() > most)
        throw Error(fmt::format("\"{}\" is {}; expected a number from {:g} to {:g}", key, value.dump(), least, most));
    return value.get<double>();
}

std::vector<double> takenSeams(nlohmann::json& part) {
    nlohmann::json value = taken(part, "seam");
    if (value.is_null()) return {0.5};
    if (!value.is_array()) value = nlohmann::json::array({value});
    std::vector<double> seams;
    for (const nlohmann::json& seam : value) {
        if (!seam.is_number() || seam.get<double>() < 0.0 || seam.get<double>() > 1.0)
            throw Error(fmt::format("\"seam\" holds {}; expected numbers from 0 to 1", seam.dump()));
        seams.push_back(seam.get<double>());
    }
    if (seams.empty()) throw Error("\"seam\" is empty; expected a number from 0 to 1 or an array of them");
    return seams;
}

ScriptPart partOf(nlohmann::json json, const nlohmann::json& common, const RecordOptions& options,
                  const std::string& place) {
    if (!json.is_object()) throw Error(fmt::format("is a JSON {}; expected an object", json.type_name()));
    ScriptPart part;
    part.frames = static_cast<int>(takenNumber(json, "frames", 0.0, 0.0, 1e6));
    part.step = takenNumber(json, "step", 1.0, 0.0, 100.0);
    part.cameraTo = takenText(json, "camera_to");
    part.seams = takenSeams(json);
    part.title = takenText(json, "title");
    part.caption = takenText(json, "caption");
    std::vector<std::string> arguments{"record"};
    std::vector<FileSetting> settings = settingsOfJson(common.dump(), place);
    const std::vector<FileSetting> own = settingsOfJson(json.dump(), place);
    settings.insert(settings.end(), own.begin(), own.end());
    for (const FileSetting& setting : settings) {
        // The command line wins, but here --scene would be what excludes a script.
        if (setting.key != "scene")
            arguments.insert(arguments.end(), setting.arguments.begin(), setting.arguments.end());
    }
    arguments.insert(arguments.end(), options.arguments.begin() + 1, options.arguments.end());
    part.drawn = std::get<RecordOptions>(parseArguments(arguments));
    if (!json.contains("scene") || !json["scene"].is_string()) throw Error("has no \"scene\"; expected a scene's name");
    part.drawn.scene = json["scene"].get<std::string>();
    if (options.frames) part.frames = *options.frames;
    return part;
}

}  // namespace

std::vector<ScriptPart> partsOf(const RecordOptions& options) {
    if (options.script.empty()) {
        ScriptPart part;
        part.drawn = options;
        part.frames = options.frames.value_or(0);
        part.seams = {options.seam};
        return {part};
    }
    const std::string text = textOfFile(options.script, "--script");
    const nlohmann::json json =
        isNestedTooDeeply(text) ? nlohmann::json() : nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object() || !json.contains("parts") || !json["parts"].is_array() || json["parts"].empty())
        throw Error(
            fmt::format("{}: expected a JSON object with \"parts\", an array of at least one part", options.script));
    const nlohmann::json common = json.value("options", nlohmann::json::object());
    std::vector<ScriptPart> parts;
    for (const nlohmann::json& part : json["parts"]) {
        const std::string place = fmt::format("{}: part {}", options.script, parts.size() + 1);
        try {
            parts.push_back(partOf(part, common, options, place));
            const PictureOptions &first = parts.front().drawn, &last = parts.back().drawn;
            if (first.width != last.width || first.height != last.height)
                throw Error(fmt::format("\"size\" is {}x{}; expected {}x{} as of the first part", last.width,
                                        last.height, first.width, first.height));
        } catch (const UsageError& error) {
            throw UsageError(fmt::format("{}: {}", place, error.what()));
        } catch (const Error& error) {
            throw Error(fmt::format("{}: {}", place, error.what()));
        }
    }
    return parts;
}

double eased(double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double easedThrough(const std::vector<double>& values, double share) {
    if (values.size() == 1) return values.front();
    const double along = std::clamp(share, 0.0, 1.0) * static_cast<double>(values.size() - 1);
    const std::size_t from = std::min(static_cast<std::size_t>(along), values.size() - 2);
    return values[from] + (values[from + 1] - values[from]) * eased(along - static_cast<double>(from));
}

}  // namespace timeshade
