#include "measure.h"

#include <timeshade/commit.h>  // generated
#include <unistd.h>
#include <array>
#include <fstream>
#include <memory>
#include <sstream>

#include <fmt/format.h>

#include "convergence.h"
#include "core/folder_lock.h"
#include "effects.h"
#include "frame_setup.h"
#include "headless_gl.h"
#include "measure/sweep_report.h"
#include "measure/technique_variant.h"
#include "output_path.h"
#include "report.h"
#include "scene_catalogue.h"
#include "standard_error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

std::string processorName() {
    std::ifstream stream("/proc/cpuinfo");
    std::string line;
    while (std::getline(stream, line))
        if (line.rfind("model name", 0) == 0)
            return fmt::format("{}, {} threads", line.substr(line.find(':') + 2), sysconf(_SC_NPROCESSORS_ONLN));
    return "unknown";
}

std::vector<std::string> techniquesOf(const MeasureOptions& options) {
    std::vector<std::string> names = options.measuredTechniques;
    if (names.empty()) {
        for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);
        names.push_back("embree");
    }
    gl::ProgramCache programs;
    for (const std::string& name : names)
        if (name != "embree") TechniqueVariant::of(name).make(options.settings, programs);  // throws for an unknown one
    return names;
}

std::vector<std::string> settingLines(const std::vector<std::string>& techniques, const MeasureOptions& options) {
    std::vector<std::string> lines;
    gl::ProgramCache programs;
    for (const std::string& name : techniques) {
        if (name == "embree") continue;
        const std::unique_ptr<Technique> technique = TechniqueVariant::of(name).make(options.settings, programs);
        for (const Setting& setting : settingsOf(*technique))
            if (setting.key != "renders")
                lines.push_back(fmt::format("{}.{} = {:g}", name, setting.key, setting.get()));
    }
    return lines;
}

/// What moves in a scene's shutter and which passes follow, for the first technique measured.
std::vector<std::string> planLines(const SweepScene& scene, const std::string& technique, const gl::DeviceInfo& device,
                                   gl::ProgramCache& programs) {
    FramePlanner planner(*scene.scene);
    const std::string name = technique == "embree" ? techniqueDescriptions().front().name : technique;
    const std::unique_ptr<Technique> planned = TechniqueVariant::of(name).make({}, programs);
    std::istringstream text(explain(planner.plan(planned->asked(scene.request)), *planned, device));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);) lines.push_back(line);
    return lines;
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
            scenes.push_back(openScene(name, options.clip, settings));
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

int runMeasure(const MeasureOptions& options) {
    if (!options.convergenceFrames.empty()) return runConvergence(options);
    if (options.effects) return runEffects(options);
    const std::filesystem::path folder = madeFolder(options.output);
    const FolderLock lock(folder);

    SweepOptions sweep;
    std::vector<std::unique_ptr<Scene>> scenes;
    sweep.techniques = techniquesOf(options);
    addScenes(options, scenes, sweep);
    sweep.settings = options.settings;
    sweep.sampleCounts = options.measuredSampleCounts;
    sweep.mapSizes = options.measuredMaps;
    sweep.rounds = options.rounds;
    sweep.sequence = options.sequenceFrames;
    sweep.referenceSamples = options.referenceSamples;
    sweep.referenceRays = options.referenceRays;
    sweep.journal = folder / "rows.jsonl";
    sweep.commit = TIMESHADE_COMMIT;
    sweep.progress = showProgress;
    sweep.note = tellNote;

    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    ReferenceCache cache;
    const std::vector<SweepRow> rows = runSweep(renderer, sweep, cache);
    if (isatty(STDERR_FILENO) == 1) writeToStandardError("\r\033[K");
    opengl.requireSilence();

    SweepManifest manifest;
    manifest.commandLine = options.commandLine;
    manifest.commit = TIMESHADE_COMMIT;
    manifest.processor = processorName();
    manifest.backEnd = opengl.backEnd();
    manifest.device = renderer.device();
    manifest.settings = settingLines(sweep.techniques, options);
    for (const SweepScene& scene : sweep.scenes)
        manifest.plans[scene.varied.empty() ? scene.name
                                            : fmt::format("{} {}={:g}", scene.name, scene.varied, scene.variedValue)] =
            planLines(scene, sweep.techniques.front(), renderer.device(), renderer.programs());
    writeSweepReport(folder, manifest, rows);
    fmt::print("{}\n", fullPath(folder / "report.md"));
    return 0;
}

}  // namespace timeshade
