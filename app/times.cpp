#include "times.h"

#include <unistd.h>

#include <fmt/format.h>

#include "core/folder_lock.h"
#include "headless_gl.h"
#include "measure/frame_times.h"
#include "output_path.h"
#include "report.h"
#include "standard_error.h"
#include "sweep_setup.h"

namespace timeshade {

int runTimes(const MeasureOptions& options) {
    std::vector<std::unique_ptr<Scene>> scenes;
    const SweepOptions sweep = sweepOf(options, false, scenes);
    const std::filesystem::path folder = madeFolder(options.output);
    const FolderLock lock(folder);
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    const std::vector<FrameTimesRow> rows = measureFrameTimes(renderer, sweep);
    if (isatty(STDERR_FILENO) == 1) writeToStandardError("\r\033[K");
    opengl.requireSilence();
    const std::string report = fmt::format(
        "# What frames take\n\n{}. {} x {}. Medians over {} rounds, with their lowest and highest, in ms; programs are "
        "compiled before. *Whole frame*: by the clock on the wall, until the device has done all. *Processor*: "
        "planning "
        "and telling the device. *Waits*: how often the processor waited for the device before the frame's end. "
        "*Uploaded*: what it handed to the device. "
        "*Device*: {}.\n\n{}",
        deviceLine(renderer.device()), options.width, options.height, options.rounds,
        renderer.device().software ? "a software renderer, which is the same processor"
                                   : "its own timestamps around each step",
        frameTimesTable(rows));
    writeFileAtomically(folder / "times.md", report);
    writeFileAtomically(folder / "times.csv", frameTimesCsv(rows));
    fmt::print("{}\n", fullPath(folder / "times.md"));
    return 0;
}

}  // namespace timeshade
