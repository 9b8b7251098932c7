#pragma once

#include <filesystem>
#include <string>

#include <nlohmann/json.hpp>

namespace timeshade {

/// What the window shows, for programs that can't see: every widget with its rectangle (window pixels: x0, y0, x1, y1),
/// its value and whether it is in view, and the state of the picture. Written as JSON to the file that the environment
/// variable TIMESHADE_UI_DUMP names, whenever it changes; does nothing without that variable.
class UiDump {
  public:
    UiDump();

    bool enabled() const { return !path_.empty(); }
    void beginFrame();
    /// The widget that ImGui has just placed.
    void lastItem(const std::string& id, const nlohmann::json& value);
    void state(const std::string& key, nlohmann::json value);
    void endFrame();

  private:
    std::filesystem::path path_;
    nlohmann::ordered_json widgets_, state_;
    std::string written_;
};

}  // namespace timeshade
