#include "settings_file.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
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

nlohmann::json parsed(const std::string& text, const std::string& path) {
    try {
        return nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        const std::size_t end = std::min(error.byte, text.size());
        const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(end), '\n');
        throw Error(fmt::format("{}:{}: is not JSON; expected an object of settings", path, line));
    } catch (const nlohmann::json::exception&) {
        throw Error(fmt::format("{}: is not JSON; expected an object of settings", path));
    }
}

}  // namespace

std::vector<FileSetting> settingsOfJson(const std::string& text, const std::string& path) {
    const nlohmann::json json = parsed(text, path);
    if (!json.is_object())
        throw Error(fmt::format("{}: holds a JSON {}; expected an object of settings", path, json.type_name()));
    const std::map<std::string, int> lines = linesOfKeys(text);
    const auto placeOf = [&](const std::string& key) { return fmt::format("{}:{}", path, lines.at(key)); };
    std::vector<FileSetting> settings;
    for (const auto& [key, value] : json.items()) {
        if (key == "set" && value.is_object()) {
            for (const auto& [name, setting] : value.items())
                settings.push_back({name, {"--set=" + name + "=" + textOf(setting)}, placeOf("set/" + name)});
        } else if (key == "window" && value.is_object()) {
            continue;
        } else if (key == "settings" || key == "help") {
            throw Error(
                fmt::format("{}: \"{}\" is not a setting; expected options that say what to draw", placeOf(key), key));
        } else if (value.is_primitive() && !value.is_null()) {
            settings.push_back({key, optionOf(key, textOf(value)), placeOf(key)});
        } else {
            throw Error(fmt::format("{}: \"{}\" is {}; expected a number, a string or a switch", placeOf(key), key,
                                    value.type_name()));
        }
    }
    return settings;
}

std::string textOfFile(const std::string& path, const std::string& option) {
    std::ifstream stream(path);
    std::ostringstream bytes;
    // A folder opens like a file and fails only when it is read.
    if (!stream || stream.peek() == std::ifstream::traits_type::eof() || !(bytes << stream.rdbuf()))
        throw Error(fmt::format("{} '{}': cannot be read; expected a JSON file of settings", option, path));
    return bytes.str();
}

std::vector<FileSetting> readSettingsFile(const std::string& path) {
    return settingsOfJson(textOfFile(path, "--settings"), path);
}

}  // namespace timeshade
