#include "equal.h"

#include <unistd.h>
#include <algorithm>
#include <filesystem>
#include <memory>

#include <fmt/format.h>

#include "core/folder_lock.h"
#include "frame_setup.h"
#include "headless_gl.h"
#include "measure/equal_report.h"
#include "measure_manifest.h"
#include "output_path.h"
#include "report.h"
#include "scene_catalogue.h"
#include "standard_error.h"

namespace timeshade {

namespace {

constexpr int steadyFramesByDefault = 3;  // timed in each round

EqualOptions equalOptionsOf(const MeasureOptions& options) {
    EqualOptions equal;
    equal.level = options.equalTime.empty() ? EqualLevel::Error : EqualLevel::Time;
    equal.techniques = options.equalTime.empty() ? options.equalError : options.equalTime;
    equal.settings = options.settings;
    equal.mapSizes = options.measuredMaps;
    equal.rounds = options.rounds;
    equal.steadyFrames = options.sequenceFrames > 0 ? options.sequenceFrames : steadyFramesByDefault;
    equal.referenceSamples = options.referenceSamples;
    equal.referenceRays = options.referenceRays;
    equal.progress = [](const std::string& what) {
        if (isatty(STDERR_FILENO) == 1) writeToStandardError("\r\033[Ktimeshade: " + what);
    };
    return equal;
}

std::string samplesInWords(const EqualRow& row) {
    return fmt::format("{} {}, map {}", row.sampleCount, row.bruteForce ? "renders" : "spp", row.mapSize.text());
}

/// The first technique, then a line for each other.
void print(const EqualScene& scene, EqualLevel level) {
    const EqualRow& first = scene.rows.front();
    fmt::print("{}: {} at {}: {:.1f} ms, shadow error {:.5f}\n", scene.name, first.technique, samplesInWords(first),
               first.steady.median, first.shadowError.rms);
    for (const EqualRow& row : scene.rows)
        if (row.find)
            fmt::print("  {} at {}: {}; {:.1f} ms, shadow error {:.5f}\n", row.technique, samplesInWords(row),
                       verdictOf(row, level, first), row.steady.median, row.shadowError.rms);
}

}  // namespace

int runEqual(const MeasureOptions& options) {
    const std::filesystem::path folder = madeFolder(options.output);
    const FolderLock lock(folder);
    const std::vector<std::string> names = options.measuredScenes.empty() ? showcase() : options.measuredScenes;
    std::vector<std::unique_ptr<Scene>> opened;  // all of them first: a wrong name costs no measurement
    std::vector<SweepScene> scenes;
    for (const std::string& name : names) {
        opened.push_back(openScene(name, choiceOf(options), options.settings));
        scenes.push_back({name, opened.back().get(), "", 0.0, requestFor(options, *opened.back())});
    }
    const EqualOptions equal = equalOptionsOf(options);
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    ReferenceCache cache;
    SweepManifest manifest = manifestOf(options, equal.techniques, opengl, renderer);
    std::vector<EqualScene> measured;
    for (const SweepScene& scene : scenes) {
        manifest.plans[scene.name] = planLines(scene, equal.techniques.front(), renderer.device(), renderer.programs());
        measured.push_back(measureEqual(renderer, equal, scene, cache));
    }
    if (isatty(STDERR_FILENO) == 1) writeToStandardError("\r\033[K");
    opengl.requireSilence();
    writeEqualReport(folder, manifest, equal.level, measured);
    fmt::print("{}\n", deviceLine(renderer.device()));
    for (const EqualScene& scene : measured) print(scene, equal.level);
    fmt::print("{}\n", fullPath(folder / "report.md"));
    return 0;
}

}  // namespace timeshade
