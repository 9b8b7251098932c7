#include "convergence.h"

#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "frame_setup.h"
#include "gl_checks.h"
#include "make_context.h"
#include "measure/convergence.h"
#include "progress.h"
#include "report.h"
#include "scene/error.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

constexpr const char* techniqueName = "history";

std::vector<std::pair<std::string, std::string>> ownSettings(const Options& options) {
    const std::string prefix = std::string(techniqueName) + ".";
    std::vector<std::pair<std::string, std::string>> own;
    for (const auto& [name, value] : options.settings)
        if (name.rfind(prefix, 0) == 0) own.emplace_back(name.substr(prefix.size()), value);
    return own;
}

} // namespace

int runConvergence(const Options& options) {
    const std::filesystem::path folder(options.output);
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure) throw Error(fmt::format("{}: cannot be made ({}); expected a folder to write to", folder.string(), failure.message()));
    std::vector<int> frames = options.historyFrames;
    std::sort(frames.begin(), frames.end());
    std::vector<std::string> names = options.measuredScenes;
    if (names.empty())
        names = {"frusta", "chess"};
    const std::unique_ptr<GlContext> context = makeContext(options.context, options.debugGl);
    const DriverWatch watch(options.debugGl);
    FrameRenderer renderer;
    std::string report = fmt::format("# Convergence of `history`\n\n{}. {} x {}, map {}, {} sample(s) a pixel.\n", deviceLine(renderer.device()), options.width,
                                     options.height, options.mapSize, options.samplesPerPixel);
    report += "Share of pixels that differ by more than 30 of 255 from the picture with ray-traced hard shadows, after so many frames of a\n"
              "moment that is held, from an empty history.\n";
    for (const std::string& name : names) {
        const std::unique_ptr<Scene> scene = openScene(name, options.clip, options.settings);
        FramePlanner planner(*scene);
        const FramePlan plan = planner.plan(requestFor(options, *scene));
        std::vector<ConvergenceCurve> curves = historyCurves();
        const Progress progress(static_cast<int>(curves.size()));
        for (std::size_t i = 0; i < curves.size(); ++i) {
            progress.update(static_cast<int>(i));
            measureConvergence(renderer, plan, techniqueName, ownSettings(options), frames, curves[i]);
        }
        const std::string stem = std::filesystem::path(name).stem().string();
        writeFileAtomically(folder / (stem + ".csv"), convergenceCsv(curves, frames));
        writePng(folder / (stem + ".png"), drawChart(convergenceChart(stem, curves, frames), 960, 640));
        writePng(folder / (stem + "-strip.png"), strip(curves.back().pictures));
        report += fmt::format("\n## {}, frame {:g}\n\n{}\n![convergence]({}.png)\n\nRepaired, left to right after {} frames:\n\n![strip]({}-strip.png)\n", stem,
                              plan.request.frame, convergenceTable(curves, frames), stem, fmt::join(frames, ", "), stem);
    }
    watch.requireSilence();
    writeFileAtomically(folder / "report.md", report);
    fmt::print("{}\n", std::filesystem::absolute(folder / "report.md").lexically_normal().string());
    return 0;
}

} // namespace timeshade
