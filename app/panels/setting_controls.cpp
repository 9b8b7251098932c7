#include "panels/setting_controls.h"

#include <algorithm>

namespace timeshade {

namespace {

/// A slider that starts at 0 and has its default near that end needs its ends drawn apart.
bool spansPowers(const Setting& setting) {
    return setting.logarithmic ||
           (setting.minimum >= 0.0 && setting.defaultValue > 0.0 && setting.maximum > 20.0 * setting.defaultValue);
}

bool drawChoice(Setting setting, const std::string& id, const std::string& label, Widgets& widgets) {
    std::vector<std::string> titles;
    for (std::string choice : setting.choices) {
        std::replace(choice.begin(), choice.end(), '-', '_');
        titles.push_back(titleOfKey(choice));
    }
    const auto current = static_cast<std::size_t>(setting.get());
    const auto chosen = widgets.combo(id, label, titles, current, setting.help, setting.choices);
    if (!chosen || *chosen == current) return false;
    setting.set(static_cast<double>(*chosen));
    return true;
}

bool drawSetting(Setting setting, const std::string& owner, Widgets& widgets) {
    const std::string id = owner + "." + setting.key, label = titleOfKey(setting.key);
    if (setting.isSwitch()) {
        bool on = setting.get() != 0.0;
        const bool changed = widgets.checkbox(id, label, on, setting.defaultValue != 0.0, setting.help);
        if (changed) setting.set(on ? 1.0 : 0.0);
        return changed;
    }
    if (setting.isChoice()) return drawChoice(setting, id, label, widgets);
    // A unit of several words does not fit into the slider, and "1 seed" says nothing.
    const bool shortUnit = setting.unit.size() <= 8;
    Widgets::Number number;
    number.minimum = setting.minimum;
    number.maximum = setting.maximum;
    number.logarithmic = spansPowers(setting);
    number.defaultValue = setting.defaultValue;
    number.help = setting.help + (shortUnit ? "" : "\nIn " + setting.unit + ".");
    const std::string unit = shortUnit && setting.unit != setting.key ? " " + setting.unit : "";
    if (setting.isWhole()) {
        number.format = "%d" + unit;
        int value = static_cast<int>(setting.get());
        const bool changed = widgets.slider(id, label, value, number);
        if (changed) setting.set(value);
        return changed;
    }
    number.format = "%.3g" + unit;
    double value = setting.get();
    const bool changed = widgets.slider(id, label, value, number);
    if (changed) setting.set(value);
    return changed;
}

}  // namespace

bool drawSettings(HasSettings& owner, const std::string& resetId, Widgets& widgets) {
    const std::vector<Setting> settings = settingsOf(owner);
    bool differs = false, changed = false;
    for (const Setting& setting : settings) {
        changed = drawSetting(setting, owner.settingsPrefix(), widgets) || changed;
        differs = differs || setting.get() != setting.defaultValue;
    }
    if (!differs || !widgets.button(resetId, "Reset all settings")) return changed;
    for (Setting setting : settings) setting.set(setting.defaultValue);
    return true;
}

}  // namespace timeshade
