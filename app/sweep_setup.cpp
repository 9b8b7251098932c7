#include "sweep_setup.h"

#include <unistd.h>

#include <fmt/format.h>

#include "frame_setup.h"
#include "measure/technique_variant.h"
#include "scene_catalogue.h"
#include "standard_error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

std::vector<std::string> techniquesOf(const MeasureOptions& options, bool withBaseline) {
    std::vector<std::string> names = options.measuredTechniques;
    if (names.empty()) {
        for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);
        if (withBaseline) names.push_back("embree");
    }
    gl::ProgramCache programs;
    for (const std::string& name : names)
        if (name != "embree" || !withBaseline)
            TechniqueVariant::onItsSamples(name).make(options.settings, programs);  // throws for an unknown one
    return names;
}

void showProgress(const std::string& what, int done, int total, double secondsLeft) {
    if (isatty(STDERR_FILENO) != 1) return;
    const std::string left = secondsLeft < 0.0 ? "" : fmt::format(", {:.0f} s left", secondsLeft);
    writeToStandardError(fmt::format("\r\033[Ktimeshade: {} of {}{}: {}", done + 1, total, left, what));
}

/// Opens the scenes to measure, a varied one once for each of its values; `scenes` owns them.
void addScenes(const MeasureOptions& options, std::vector<std::unique_ptr<Scene>>& scenes, SweepOptions& sweep) {
    const std::vector<std::string> names = options.measuredScenes.empty() ? showcase() : options.measuredScenes;
    const std::string variedScene = options.variedSetting.substr(0, options.variedSetting.find('.'));
    for (const std::string& name : names) {
        const auto add = [&](const SettingTexts& settings, const std::string& varied, double value) {
            scenes.push_back(openScene(name, choiceOf(options), settings));
            sweep.scenes.push_back({name, scenes.back().get(), varied, value, requestFor(options, *scenes.back())});
        };
        if (name != variedScene) add(options.settings, "", 0.0);
        for (const std::string& value : name == variedScene ? options.variedValues : std::vector<std::string>{}) {
            SettingTexts settings = options.settings;
            settings.emplace_back(options.variedSetting, value);
            add(settings, options.variedSetting, std::stod(value));
        }
    }
}

}  // namespace

SweepOptions sweepOf(const MeasureOptions& options, bool withBaseline, std::vector<std::unique_ptr<Scene>>& scenes) {
    SweepOptions sweep;
    sweep.techniques = techniquesOf(options, withBaseline);
    addScenes(options, scenes, sweep);
    sweep.settings = options.settings;
    sweep.sampleCounts = options.measuredSampleCounts;
    sweep.mapSizes = options.measuredMaps;
    sweep.rounds = options.rounds;
    sweep.sequence = options.sequenceFrames;
    sweep.progress = showProgress;
    return sweep;
}

}  // namespace timeshade
