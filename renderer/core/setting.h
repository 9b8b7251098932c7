#pragma once

#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace timeshade {

/// One setting of a technique or of a scene: where its value lies, what it may be and what it does. Declared once;
/// sliders, `--set`, settings files, manifests and `list` all follow from it.
struct Setting {
    std::string key;  ///< lower case with underscores; "tsm.bias" on the command line
    std::variant<float*, int*, bool*> value;
    double defaultValue = 0.0;
    double minimum = 0.0, maximum = 1.0;  ///< both may be taken
    std::string unit;                     ///< "texels", "renders", ...; empty for a switch
    std::string help;                     ///< one or two sentences: what it does, and what more of it costs
    bool logarithmic = false;             ///< for a slider that spans powers
    std::vector<std::string> choices;     ///< names of the values 0, 1, ...; empty where it is a number or a switch

    double get() const;
    void set(double number);  ///< the caller has checked the range
    bool isSwitch() const { return std::holds_alternative<bool*>(value); }
    bool isChoice() const { return !choices.empty(); }
    bool isWhole() const { return !std::holds_alternative<float*>(value); }
};

/// Receives the settings in the order in which they should be shown.
class SettingsVisitor {
  public:
    virtual ~SettingsVisitor() = default;
    virtual void visit(const Setting& setting) = 0;

    void number(std::string key, float& value, double defaultValue, double minimum, double maximum, std::string unit,
                std::string help) {
        visit({std::move(key), &value, defaultValue, minimum, maximum, std::move(unit), std::move(help), false, {}});
    }
    void whole(std::string key, int& value, double defaultValue, double minimum, double maximum, std::string unit,
               std::string help, bool logarithmic = false) {
        visit({std::move(key),
               &value,
               defaultValue,
               minimum,
               maximum,
               std::move(unit),
               std::move(help),
               logarithmic,
               {}});
    }
    /// One of several names. Written as its name; a number is taken, too, as older settings files have it. If the first
    /// is "off", so is "on" for the second: what was a switch once may become a choice.
    void choice(std::string key, int& value, int defaultValue, std::vector<std::string> choices, std::string help) {
        const auto last = static_cast<double>(choices.size()) - 1.0;
        visit({std::move(key), &value, static_cast<double>(defaultValue), 0.0, last, "", std::move(help), false,
               std::move(choices)});
    }
    void toggle(std::string key, bool& value, bool defaultValue, std::string help) {
        visit({std::move(key), &value, defaultValue ? 1.0 : 0.0, 0.0, 1.0, "", std::move(help), false, {}});
    }
};

/// What declares settings: everything that --set can name the settings of.
class HasSettings {
  public:
    virtual ~HasSettings() = default;
    /// What stands before the dot on the command line: "tsm" in "tsm.bias".
    virtual const std::string& settingsPrefix() const = 0;
    virtual void visitSettings(SettingsVisitor& visitor) = 0;
};

/// The owner's settings as a list. The pointers stay valid as long as the owner.
std::vector<Setting> settingsOf(HasSettings& owner);

/// Gives every setting the default that its declaration names.
void resetSettings(HasSettings& owner);

/// The value as --set takes it: "0.5", "12", "on", or the name of a choice.
std::string textOf(const Setting& setting);

/// Sets one setting from text ("0.5", "12", "on"). Throws UsageError that names the key, the text and what was
/// expected.
void setFromText(HasSettings& owner, const std::string& key, const std::string& text);

}  // namespace timeshade
