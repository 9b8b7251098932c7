#include "measure.h"

#include <timeshade/commit.h>  // generated
#include <unistd.h>
#include <memory>

#include <fmt/format.h>

#include "convergence.h"
#include "core/folder_lock.h"
#include "effects.h"
#include "equal.h"
#include "frame_setup.h"
#include "headless_gl.h"
#include "measure/sweep_report.h"
#include "measure/technique_variant.h"
#include "measure_manifest.h"
#include "output_path.h"
#include "scene_catalogue.h"
#include "standard_error.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

std::vector<std::string> techniquesOf(const MeasureOptions& options) {
    std::vector<std::string> names = options.measuredTechniques;
    if (names.empty()) {
        for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);
        names.push_back("embree");
    }
    gl::ProgramCache programs;
    for (const std::string& name : names)
        if (name != "embree")
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

int runMeasure(const MeasureOptions& options) {
    if (!options.convergenceFrames.empty()) return runConvergence(options);
    if (options.effects) return runEffects(options);
    if (!options.equalTime.empty() || !options.equalError.empty()) return runEqual(options);
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

    SweepManifest manifest = manifestOf(options, sweep.techniques, opengl, renderer);
    for (const SweepScene& scene : sweep.scenes)
        manifest.plans[scene.varied.empty() ? scene.name
                                            : fmt::format("{} {}={:g}", scene.name, scene.varied, scene.variedValue)] =
            planLines(scene, sweep.techniques.front(), renderer.device(), renderer.programs());
    writeSweepReport(folder, manifest, rows);
    fmt::print("{}\n", fullPath(folder / "report.md"));
    return 0;
}

}  // namespace timeshade
