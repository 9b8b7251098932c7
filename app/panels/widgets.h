#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <imgui.h>

#include "window/ui_dump.h"

namespace timeshade {

enum class Icon { Play, Pause, StepBack, StepForward, Reset, Close };

/// The few controls that all panels are made of: a label on the left, the control beside it, help and reset behind it.
/// Ids are unique in the window; they name the control for ImGui and in the dump.
class Widgets {
  public:
    /// `sections`: those that are not as `open` says, by id; kept up to date.
    Widgets(UiDump& dump, float scale, std::map<std::string, bool>& sections)
        : dump_(dump), scale_(scale), sections_(sections) {}

    float scale() const { return scale_; }
    UiDump& dump() { return dump_; }

    struct Number {
        double minimum = 0.0, maximum = 1.0;  ///< of the slider
        std::optional<double> least, most;    ///< what may be typed (Ctrl and a click), where that is more
        std::string format = "%.3g";
        bool logarithmic = false;
        std::optional<double> defaultValue;  ///< adds a reset
        std::string help;
    };

    /// A heading that folds what follows. False while folded. `open`: whether it is unfolded at a first start.
    bool section(const std::string& id, const char* title, bool open);
    bool slider(const std::string& id, const std::string& label, double& value, const Number& number);
    bool slider(const std::string& id, const std::string& label, int& value, const Number& number);
    bool checkbox(const std::string& id, const std::string& label, bool& value, bool defaultValue,
                  const std::string& help);
    /// The entry that was chosen just now. `ids` name the entries in the dump; empty for the entries' own text.
    std::optional<std::size_t> combo(const std::string& id, const std::string& label,
                                     const std::vector<std::string>& entries, std::size_t current,
                                     const std::string& help, const std::vector<std::string>& ids = {});
    /// Buttons side by side, one of which is down. The one that was pressed just now. `ids` as for combo.
    std::optional<std::size_t> choice(const std::string& id, const std::vector<std::string>& entries,
                                      std::size_t current, const std::vector<std::string>& ids = {});
    /// Tabs beside each other, of which one is open: the one that was pressed just now. `ids` as for combo.
    std::optional<std::size_t> tabs(const std::string& id, const std::vector<std::string>& titles, std::size_t current,
                                    const std::vector<std::string>& ids);
    bool button(const std::string& id, const std::string& text, float width = 0.0f);
    bool iconButton(const std::string& id, Icon icon, const char* tooltip, float side);
    /// Text typed into a field that fills the row up to `reserved`. True when Enter is pressed.
    bool field(const std::string& id, const char* hint, std::string& text, float reserved);
    void paragraph(const std::string& text, const ImVec4& color);
    /// A label and a value, right-aligned.
    void figure(const std::string& id, const std::string& label, const std::string& value);

  private:
    void beginRow(const std::string& label, const std::string& helpText = {});
    void help(const std::string& text);
    /// True when pressed. Shown only where the value is not the default.
    bool reset(const std::string& id, bool differs);

    UiDump& dump_;
    float scale_;
    std::map<std::string, bool>& sections_;
};

/// "dynamic_bias" as "Dynamic bias".
std::string titleOfKey(const std::string& key);

}  // namespace timeshade
