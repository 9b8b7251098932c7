#include "settings_file.h"

#include <algorithm>
#include <array>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/file_bytes.h"
#include "core/json_limits.h"
#include "core/one_line.h"
#include "json_lines.h"

namespace timeshade {

namespace {

std::string textOf(const nlohmann::json& value) { return value.is_string() ? value.get<std::string>() : value.dump(); }

/// Joined, so that a switch's value is not taken for the scene, nor a negative number for an option. But CLI11 goes on
/// to the next argument where nothing follows the equals sign.
std::vector<std::string> optionOf(const std::string& key, const std::string& value) {
    if (value.empty()) return {"--" + key, ""};
    return {"--" + key + "=" + value};
}

/// Says what to draw and how to measure it. Not what names an output, a device or a folder, nor what asks for help: a
/// file that comes with a scene may be anybody's, and looking at a picture must not overwrite anything.
constexpr std::array allowedKeys{"scene",
                                 "size",
                                 "spp",
                                 "map",
                                 "seed",
                                 "frame",
                                 "time",
                                 "fps",
                                 "clip",
                                 "shutter",
                                 "instant",
                                 "camera",
                                 "pose",
                                 "shutter-position",
                                 "technique",
                                 "view",
                                 "compare",
                                 "compare-mode",
                                 "compare-gain",
                                 "seam",
                                 "force-dynamic",
                                 "no-plan",
                                 "no-cache",
                                 "no-keep",
                                 "frames",
                                 "codec",
                                 "quality",
                                 "techniques",
                                 "maps",
                                 "spps",
                                 "rounds",
                                 "sequence",
                                 "reference",
                                 "vary",
                                 "reference-rays",
                                 "convergence",
                                 "effects",
                                 "explain",
                                 "gl-debug",
                                 "max-ppm",
                                 "history-frames",
                                 "set",
                                 "pixel-centres",
                                 "loop",
                                 "shutter-response",
                                 "samples",
                                 "time-strata",
                                 "shutter-width",
                                 "motion-steps",
                                 "equal-time",
                                 "equal-error",
                                 "times",
                                 "light",
                                 "light-direction",
                                 "light-distance",
                                 "light-cone",
                                 "light-intensity",
                                 "light-move",
                                 "light-turn",
                                 "ground",
                                 "ground-height",
                                 "ground-size",
                                 "exposure",
                                 "tone-map"};

void requireAllowed(const std::string& key, const std::string& place) {
    if (std::find(allowedKeys.begin(), allowedKeys.end(), key) == allowedKeys.end())
        throw Error(
            fmt::format("{}: \"{}\" is not a setting of a file; expected options that say what to draw, not "
                        "where to write or on which device",
                        place, oneLine(key)));
}

nlohmann::json parsed(const std::string& text, const std::string& path, int firstLine) {
    if (isNestedTooDeeply(text))
        throw Error(
            fmt::format("{}: is nested more than {} levels deep; expected an object of settings", path, deepestJson));
    if (text.find('\0') != std::string::npos)  // where the parser would end, and call all before it whole
        throw Error(fmt::format("{}: holds a zero byte; expected an object of settings", path));
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t end = std::min(error.byte, text.size());
        const auto line = firstLine + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        throw Error(fmt::format("{}:{}: is not JSON; expected an object of settings", path, line));
    } catch (const nlohmann::json::exception&) {
        throw Error(fmt::format("{}: is not JSON; expected an object of settings", path));
    }
}

}  // namespace

std::vector<FileSetting> settingsOfJson(const std::string& text, const std::string& path, int firstLine,
                                        const std::vector<std::string>& others) {
    const nlohmann::json json = parsed(text, path, firstLine);
    if (!json.is_object())
        throw Error(fmt::format("{}: holds a JSON {}; expected an object of settings", path, json.type_name()));
    const std::map<std::string, int> lines = linesOfKeys(text);
    const auto placeOf = [&](const std::string& key) {
        return fmt::format("{}:{}", path, lines.at(key) + firstLine - 1);
    };
    std::vector<FileSetting> settings;
    for (const auto& [key, value] : json.items()) {
        if (key == "set" && value.is_object()) {
            for (const auto& [name, setting] : value.items())
                settings.push_back({name, {"--set=" + name + "=" + textOf(setting)}, placeOf("set/" + name)});
            continue;
        }
        if ((key == "window" && value.is_object()) || std::find(others.begin(), others.end(), key) != others.end())
            continue;
        requireAllowed(key, placeOf(key));
        if (value.is_primitive() && !value.is_null()) {
            settings.push_back({key, optionOf(key, textOf(value)), placeOf(key)});
        } else {
            throw Error(fmt::format("{}: \"{}\" is {}; expected a number, a string or a switch", placeOf(key), key,
                                    value.type_name()));
        }
    }
    return settings;
}

std::string textOfFile(const std::string& path, const std::string& option) {
    try {
        return readFileText(path, largestSettingsFile);
    } catch (const Error& error) {
        throw Error(fmt::format("{} '{}': {}; expected a JSON file of settings", option, path, error.what()));
    }
}

std::vector<FileSetting> readSettingsFile(const std::string& path) {
    return settingsOfJson(textOfFile(path, "--settings"), path);
}

}  // namespace timeshade
