#include "panels/panels.h"
#include "panels/theme.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

/// A slider that starts at 0 and has its default near that end needs its ends drawn apart.
bool spansPowers(const Setting& setting) {
    return setting.logarithmic || (setting.minimum >= 0.0 && setting.defaultValue > 0.0 && setting.maximum > 20.0 * setting.defaultValue);
}

void drawSetting(Setting setting, const std::string& technique, Widgets& widgets) {
    const std::string id = technique + "." + setting.key, label = titleOfKey(setting.key);
    if (setting.isSwitch()) {
        bool on = setting.get() != 0.0;
        if (widgets.checkbox(id, label, on, setting.defaultValue != 0.0, setting.help)) setting.set(on ? 1.0 : 0.0);
        return;
    }
    // A unit of several words does not fit into the slider.
    const bool shortUnit = setting.unit.size() <= 8;
    Widgets::Number number;
    number.minimum = setting.minimum;
    number.maximum = setting.maximum;
    number.logarithmic = spansPowers(setting);
    number.defaultValue = setting.defaultValue;
    number.help = setting.help + (shortUnit ? "" : "\nIn " + setting.unit + ".");
    const std::string unit = shortUnit ? " " + setting.unit : "";
    if (setting.isWhole()) {
        number.format = "%d" + unit;
        int value = static_cast<int>(setting.get());
        if (widgets.slider(id, label, value, number)) setting.set(value);
    } else {
        number.format = "%.3g" + unit;
        double value = setting.get();
        if (widgets.slider(id, label, value, number)) setting.set(value);
    }
}

} // namespace

void drawTechniquePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.technique", "Technique", true)) return;
    const std::vector<TechniqueDescription>& all = techniqueDescriptions();
    const TechniqueDescription& now = session.technique->description();
    std::vector<std::string> titles;
    std::size_t current = 0;
    for (const TechniqueDescription& description : all) {
        if (description.name == now.name) current = titles.size();
        titles.push_back(description.title);
    }
    if (const auto chosen = widgets.combo("technique", "", titles, current, "")) session.wishedTechnique = all[*chosen].name;
    widgets.paragraph(now.summary, theme::quiet);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", now.source.c_str());

    const std::vector<Setting> settings = settingsOf(*session.technique);
    bool differs = false;
    for (const Setting& setting : settings) {
        drawSetting(setting, now.name, widgets);
        differs = differs || setting.get() != setting.defaultValue;
    }
    if (differs && widgets.button("technique.reset", "Reset all settings"))
        for (Setting setting : settings) setting.set(setting.defaultValue);
}

} // namespace timeshade
