#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "headless.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

nlohmann::ordered_json asJson(const Setting& setting) {
    nlohmann::ordered_json json{{"key", setting.key}};
    if (setting.isSwitch()) {
        json["default"] = setting.defaultValue != 0.0;
    } else {
        if (setting.isChoice()) json["choices"] = setting.choices;  // the names of the values from the minimum on
        json["default"] = setting.defaultValue;
        json["minimum"] = setting.minimum;
        json["maximum"] = setting.maximum;
        json["unit"] = setting.unit;
    }
    json["help"] = setting.help;
    return json;
}

void listAsJson() {
    nlohmann::ordered_json json;
    for (const BuiltInScene& scene : builtInScenes()) {
        nlohmann::ordered_json entry{
            {"name", scene.name}, {"summary", scene.summary}, {"settings", nlohmann::ordered_json::array()}};
        if (const std::unique_ptr<SceneRecipe> recipe = makeRecipe(scene.name))
            for (const Setting& setting : settingsOf(*recipe)) entry["settings"].push_back(asJson(setting));
        json["scenes"].push_back(entry);
    }
    for (const BuiltInScene& scene : caseScenes())
        json["cases"].push_back({{"name", scene.name}, {"summary", scene.summary}});
    gl::ProgramCache programs;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        nlohmann::ordered_json technique{{"name", description.name},
                                         {"title", description.title},
                                         {"summary", description.summary},
                                         {"source", description.source},
                                         {"settings", nlohmann::ordered_json::array()}};
        for (const Setting& setting : settingsOf(*makeTechnique(description.name, programs)))
            technique["settings"].push_back(asJson(setting));
        technique["views"] = nlohmann::ordered_json::array();
        for (const TechniqueView& view : makeTechnique(description.name, programs)->views())
            technique["views"].push_back({{"name", view.name}, {"title", view.title}, {"unit", view.unit}});
        json["techniques"].push_back(technique);
    }
    fmt::print("{}\n", json.dump(2));
}

/// The default, and what else there is.
std::string rangeOf(const Setting& setting) {
    if (setting.isSwitch()) return fmt::format("{} (on or off)", setting.defaultValue != 0.0 ? "on" : "off");
    if (setting.isChoice())
        return fmt::format("{} ({})", setting.choices[static_cast<std::size_t>(setting.defaultValue)],
                           fmt::join(setting.choices, ", "));
    return fmt::format("{:g} ({:g} to {:g}, {})", setting.defaultValue, setting.minimum, setting.maximum, setting.unit);
}

void listSetting(const std::string& owner, const Setting& setting) {
    fmt::print("    {}.{} = {}\n        {}\n", owner, setting.key, rangeOf(setting), setting.help);
}

void listAsText() {
    fmt::print("scenes (or a path to a .gltf or .glb file), and the settings of those that are computed, for --set\n");
    for (const BuiltInScene& scene : builtInScenes()) {
        fmt::print("  {:<13} {}\n", scene.name, scene.summary);
        if (const std::unique_ptr<SceneRecipe> recipe = makeRecipe(scene.name))
            for (const Setting& setting : settingsOf(*recipe)) listSetting(scene.name, setting);
    }
    fmt::print("\nanalytic cases (with exact values), as scenes\n");
    for (const BuiltInScene& scene : caseScenes()) fmt::print("  {}\n      {}\n", scene.name, scene.summary);
    fmt::print("\ntechniques, and their settings for --set\n");
    gl::ProgramCache programs;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        fmt::print("  {:<13} {}\n  {:<13} ({})\n", description.name, description.summary, "", description.source);
        for (const Setting& setting : settingsOf(*makeTechnique(description.name, programs)))
            listSetting(description.name, setting);
        for (const TechniqueView& view : makeTechnique(description.name, programs)->views())
            fmt::print("    --view {}\n        {}\n", view.name, view.title);
    }
}

void listDeviceNames(bool json) {
    const std::vector<DeviceDescription> devices = listDevices();
    if (json) {
        nlohmann::ordered_json array = nlohmann::ordered_json::array();
        for (const DeviceDescription& device : devices)
            array.push_back({{"index", device.index}, {"name", device.name}});
        fmt::print("{}\n", array.dump(2));
        return;
    }
    if (devices.empty()) fmt::print("no EGL devices\n");
    for (const DeviceDescription& device : devices) fmt::print("{:>3}  {}\n", device.index, device.name);
}

}  // namespace

int runList(const ListOptions& options) {
    if (options.devices)
        listDeviceNames(options.json);
    else if (options.json)
        listAsJson();
    else
        listAsText();
    return 0;
}

}  // namespace timeshade
