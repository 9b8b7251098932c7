#include "measure.h"

#include <timeshade/commit.h>  // generated
#include <unistd.h>
#include <memory>

#include <fmt/format.h>

#include "convergence.h"
#include "core/folder_lock.h"
#include "effects.h"
#include "equal.h"
#include "headless_gl.h"
#include "measure/sweep_report.h"
#include "measure_manifest.h"
#include "output_path.h"
#include "standard_error.h"
#include "sweep_setup.h"
#include "times.h"

namespace timeshade {

int runMeasure(const MeasureOptions& options) {
    if (!options.convergenceFrames.empty()) return runConvergence(options);
    if (options.effects) return runEffects(options);
    if (options.times) return runTimes(options);
    if (!options.equalTime.empty() || !options.equalError.empty()) return runEqual(options);
    std::vector<std::unique_ptr<Scene>> scenes;
    SweepOptions sweep = sweepOf(options, true, scenes);
    const std::filesystem::path folder = madeFolder(options.output);
    const FolderLock lock(folder);
    sweep.referenceSamples = options.referenceSamples;
    sweep.referenceRays = options.referenceRays;
    sweep.journal = folder / "rows.jsonl";
    sweep.commit = TIMESHADE_COMMIT;
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
