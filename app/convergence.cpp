#include "convergence.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "core/error.h"
#include "frame_setup.h"
#include "gl_checks.h"
#include "make_context.h"
#include "measure/convergence.h"
#include "measure/detail_strip.h"
#include "progress.h"
#include "report.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

constexpr const char* techniqueName = "history";
constexpr int stripSide = 96, stripZoom = 2;  // pixels of the picture; pixels of the strip for each

std::vector<std::pair<std::string, std::string>> ownSettings(const MeasureOptions& options) {
    const std::string prefix = std::string(techniqueName) + ".";
    std::vector<std::pair<std::string, std::string>> own;
    for (const auto& [name, value] : options.settings)
        if (name.rfind(prefix, 0) == 0) own.emplace_back(name.substr(prefix.size()), value);
    return own;
}

/// Frames of a camera that turns by a tenth of a degree a frame and comes to where the request has it.
std::vector<FramePlan> cameraStops(FramePlanner& planner, FrameRequest request) {
    constexpr int count = 20;
    constexpr double step = 0.1 * 3.14159265358979324 / 180.0;
    const CameraPose end = *request.cameraPose;
    std::vector<FramePlan> plans;
    for (int k = count; k > 0; --k) {
        const double c = std::cos(k * step), s = std::sin(k * step);
        request.cameraPose->axes =
            glm::dmat3(c * end.axes[0] - s * end.axes[2], end.axes[1], s * end.axes[0] + c * end.axes[2]);
        plans.push_back(planner.plan(request));
    }
    return plans;
}

/// Of a curve's pictures those that the strip shows: as figure 5 of the paper, after 1, 20, 40, 60 frames; or all,
/// where one of them is missing.
std::vector<DisplayImage> shownInStrip(const ConvergenceCurve& curve, const std::vector<int>& frames,
                                       const std::vector<int>& shown) {
    std::vector<DisplayImage> pictures;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (std::find(shown.begin(), shown.end(), frames[i]) != shown.end()) pictures.push_back(curve.pictures[i]);
    return pictures;
}

const ConvergenceCurve& curveNamed(const std::vector<ConvergenceCurve>& curves, const std::string& name) {
    return *std::find_if(curves.begin(), curves.end(),
                         [&](const ConvergenceCurve& curve) { return curve.name == name; });
}

}  // namespace

int runConvergence(const MeasureOptions& options) {
    const std::filesystem::path folder(options.output);
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw Error(
            fmt::format("{}: cannot be made ({}); expected a folder to write to", folder.string(), failure.message()));
    std::vector<int> frames = options.historyFrames;
    std::sort(frames.begin(), frames.end());
    std::vector<std::string> names = options.measuredScenes;
    if (names.empty()) names = {"frusta", "chess"};
    const std::unique_ptr<GlContext> context = makeContext(options.context, options.debugGl);
    const DriverWatch watch(options.debugGl);
    FrameRenderer renderer;
    std::string report = fmt::format("# Convergence of `history`\n\n{}. {} x {}, map {}, {} sample(s) a pixel.\n",
                                     deviceLine(renderer.device()), options.width, options.height, options.mapSize,
                                     options.samplesPerPixel);
    report +=
        "Share of pixels that differ by more than 30 of 255 from the picture with ray-traced hard shadows, after so "
        "many frames of a\n"
        "moment that is held, from an empty history or, after motion, from one that was filled while the camera turned "
        "by a tenth of a degree a frame.\n";
    std::vector<int> shown{1, 20, 40, 60};
    if (!std::includes(frames.begin(), frames.end(), shown.begin(), shown.end())) shown = frames;
    for (const std::string& name : names) {
        const std::unique_ptr<Scene> scene = openScene(name, options.clip, options.settings);
        FramePlanner planner(*scene);
        FrameRequest request = requestFor(options, *scene);
        // Held still, as motion of the camera within the shutter would leave no pixel a truth of its own.
        if (!request.cameraPose)
            request.cameraPose = scene->camera(request.cameraIndex, request.shutter.openSeconds(request.frame));
        const FramePlan plan = planner.plan(request);
        const std::vector<FramePlan> approach = cameraStops(planner, request);
        const DisplayImage reference = referencePicture(renderer, plan);
        std::vector<ConvergenceCurve> curves = historyCurves();
        const Progress progress(static_cast<int>(curves.size()));
        for (std::size_t i = 0; i < curves.size(); ++i) {
            progress.update(static_cast<int>(i));
            measureConvergence(renderer, approach, plan, reference, techniqueName, ownSettings(options), frames,
                               curves[i]);
        }
        const std::string stem = std::filesystem::path(name).stem().string();
        const ConvergenceCurve &published = curveNamed(curves, "as published, m from 3 to 15"),
                               &repaired = curveNamed(curves, "repaired");
        const PixelSquare square = worstSquare(published.pictures.back(), reference, stripSide);
        writeFileAtomically(folder / (stem + ".csv"), convergenceCsv(curves, frames));
        writePng(folder / (stem + ".png"), drawChart(convergenceChart(stem, curves, frames), 960, 640));
        writePng(folder / (stem + "-strip.png"),
                 detailStrip({shownInStrip(published, frames, shown), shownInStrip(repaired, frames, shown)}, square,
                             stripZoom));
        report += fmt::format(
            "\n## {}, frame {:g}\n\n{}\n![convergence]({}.png)\n\nA detail, left to right after {} frames; above as "
            "published, below repaired:\n\n"
            "![strip]({}-strip.png)\n",
            stem, plan.request.frame, convergenceTable(curves, frames), stem, fmt::join(shown, ", "), stem);
    }
    watch.requireSilence();
    writeFileAtomically(folder / "report.md", report);
    fmt::print("{}\n", std::filesystem::absolute(folder / "report.md").lexically_normal().string());
    return 0;
}

}  // namespace timeshade
