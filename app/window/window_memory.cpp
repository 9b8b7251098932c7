#include "window/window_memory.h"

#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "core/json_limits.h"
#include "image/image_file.h"
#include "measure/user_folder.h"
#include "settings_file.h"
#include "window/preview_quality.h"

namespace timeshade {

namespace {

constexpr int leastWidth = 320, leastHeight = 240, maxSide = 16384;
constexpr double secondsUntilWritten = 1.0;

bool isSize(const nlohmann::json& value) {
    if (!value.is_array() || value.size() != 2 || !value[0].is_number_integer() || !value[1].is_number_integer())
        return false;
    const auto width = value[0].get<long long>(), height = value[1].get<long long>();
    return width >= leastWidth && width <= maxSide && height >= leastHeight && height <= maxSide;
}

/// False where the value makes no sense.
bool take(const std::string& key, const nlohmann::json& value, WindowMemory& memory) {
    if (key == "size") {
        if (!isSize(value)) return false;
        memory.width = value[0].get<int>();
        memory.height = value[1].get<int>();
    } else if (key == "text_size") {
        if (!value.is_number() || value.get<double>() < 0.75 || value.get<double>() > 2.5) return false;
        memory.textScale = value.get<double>();
    } else if (key == "sections") {
        if (!value.is_object()) return false;
        for (const auto& [id, unfolded] : value.items()) {
            if (!unfolded.is_boolean()) return false;
            memory.sections[id] = unfolded.get<bool>();
        }
    } else if (key == "story_closed") {
        if (!value.is_boolean()) return false;
        memory.storyClosed = value.get<bool>();
    } else if (key == "panel_width") {
        if (!value.is_number() || value.get<double>() < 0.0 || value.get<double>() > maxSide) return false;
        memory.panelWidth = value.get<double>();
    } else if (key == "preview") {
        if (!value.is_string() || !previewOf(value.get<std::string>())) return false;
        memory.preview = value.get<std::string>();
    } else if (key == "recent") {
        if (!value.is_array()) return false;
        for (const nlohmann::json& path : value) {
            if (!path.is_string()) return false;
            memory.recentScenes.push_back(path.get<std::string>());
        }
    }
    return true;
}

}  // namespace

WindowMemory memoryOfJson(const std::string& text, const std::string& path) {
    const nlohmann::json json =
        isNestedTooDeeply(text) ? nlohmann::json() : nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object())
        throw Error(fmt::format("{}: is no JSON object; the window begins as at a first start", path));
    WindowMemory memory;
    for (const auto& [key, value] : json.items())
        if (!take(key, value, memory))
            throw Error(fmt::format("{}: \"{}\" is {}; the window begins as at a first start", path, key,
                                    value.dump().substr(0, 60)));
    return memory;
}

std::string jsonOf(const WindowMemory& memory) {
    nlohmann::ordered_json json;
    if (memory.width >= leastWidth && memory.height >= leastHeight) json["size"] = {memory.width, memory.height};
    json["text_size"] = memory.textScale;
    json["sections"] = memory.sections;
    json["story_closed"] = memory.storyClosed;
    json["panel_width"] = memory.panelWidth;
    json["preview"] = memory.preview;
    json["recent"] = memory.recentScenes;
    // Names of files need not be UTF-8.
    return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

MemoryFile::MemoryFile() : path_(userFolder("XDG_CONFIG_HOME", ".config")) {
    if (path_.empty()) return;
    path_ /= "window.json";
    std::error_code failure;
    if (!std::filesystem::exists(path_, failure) && !failure) return;
    try {
        written_ = memoryOfJson(textOfFile(path_.string(), "window layout"), path_.string());
    } catch (const std::exception& error) {
        complaint_ = error.what();
    }
    wanted_ = written_;
}

std::optional<std::string> MemoryFile::takeComplaint() { return std::exchange(complaint_, std::nullopt); }

void MemoryFile::keep(const WindowMemory& now, double seconds) {
    if (path_.empty()) return;
    if (now != wanted_) {
        wanted_ = now;
        changed_ = seconds;
    } else if (wanted_ != written_ && seconds - changed_ > secondsUntilWritten) {
        write();
    }
}

void MemoryFile::finish() {
    if (!path_.empty() && wanted_ != written_) write();
}

void MemoryFile::write() {
    written_ = wanted_;
    try {
        std::filesystem::create_directories(path_.parent_path());
        writeFileAtomically(path_, jsonOf(written_));
    } catch (const std::exception& error) {
        complaint_ = fmt::format("The window's layout will not be remembered: {}", error.what());
        path_.clear();
    }
}

}  // namespace timeshade
