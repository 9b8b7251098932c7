#include "convergence.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

#include <fmt/format.h>

#include "core/folder_lock.h"
#include "frame_setup.h"
#include "headless_gl.h"
#include "measure/convergence.h"
#include "measure/detail_strip.h"
#include "output_path.h"
#include "progress.h"
#include "report.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

constexpr int stripSide = 96, stripZoom = 2;  // pixels of the picture; pixels of the strip for each

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

/// Of a curve's pictures those after the `shown` numbers of frames.
std::vector<DisplayImage> shownInStrip(const ConvergenceCurve& curve, const std::vector<int>& frames,
                                       const std::vector<int>& shown) {
    std::vector<DisplayImage> pictures;
    for (std::size_t i = 0; i < frames.size(); ++i)
        if (std::find(shown.begin(), shown.end(), frames[i]) != shown.end()) pictures.push_back(curve.pictures[i]);
    return pictures;
}

/// As figure 5 of Scherzer, Jeschke, Wimmer 2007 after 1, 20, 40, 60 frames; after all, where one of them is missing.
std::vector<int> framesOfStrip(const std::vector<int>& frames) {
    const std::vector<int> shown{1, 20, 40, 60};
    return std::includes(frames.begin(), frames.end(), shown.begin(), shown.end()) ? shown : frames;
}

std::string head(const MeasureOptions& options, const gl::DeviceInfo& device) {
    return fmt::format(
        "# Convergence of a still picture\n\n{}. {} x {}, shadow map {}, samples per pixel: {}.\n"
        "Share of pixels that differ by more than 30 of 255 from the picture with ray-traced hard shadows, after so "
        "many frames of a moment that is held, from an empty history or, after motion, from one that was filled while "
        "the camera turned by a tenth of a degree per frame. The first frame of the moment that is held is frame 1, in "
        "figure 3 of Scherzer, Jeschke, Wimmer 2007 frame 0; that figure compares with the technique's own converged "
        "picture, as the second tables do: the one after {} frames of the moment from an empty history.\n",
        deviceLine(device), options.width, options.height, options.mapSize.text(), options.samplesPerPixel,
        convergedFrames);
}

/// Measures all curves of one moment. The references of the first.
ConvergenceReferences measureCurves(FrameRenderer& renderer, FramePlanner& planner, const FrameRequest& request,
                                    const MeasureOptions& options, const std::vector<int>& frames,
                                    std::vector<ConvergenceCurve>& curves) {
    std::optional<ConvergenceReferences> first;
    ConvergenceReferences references;
    std::unique_ptr<Technique> technique;
    StillMoment moment;
    const Progress progress(static_cast<int>(curves.size()));
    for (std::size_t i = 0; i < curves.size(); ++i) {
        progress.update(static_cast<int>(i));
        if (i == 0 || curves[i].variant != curves[i - 1].variant) {
            technique = convergingTechnique(renderer, curves[i].variant, options.settings);
            const FrameRequest asked = technique->asked(request);
            moment = {planner.plan(asked), cameraStops(planner, asked)};
            references = convergenceReferences(renderer, moment.plan, *technique);
            if (!first) first = references;
        }
        measureConvergence(renderer, moment, *technique, references, frames, curves[i]);
    }
    return *first;
}

/// Measures one scene and writes its table, chart and details; what the report says of it.
std::string sceneSection(FrameRenderer& renderer, const MeasureOptions& options, const std::string& name,
                         const std::vector<int>& frames, std::vector<ConvergenceCurve> curves) {
    requireStrata(options, "--convergence");
    requireOneMotionStep(options, "--convergence");
    const std::unique_ptr<Scene> scene = openScene(name, choiceOf(options), options.settings);
    FramePlanner planner(*scene);
    FrameRequest request = requestFor(options, *scene);
    // Held still: with a camera that moves within the shutter no pixel would have one true value.
    if (!request.cameraPose)
        request.cameraPose = scene->camera(request.cameraIndex, shutterTimes(*scene, request).open);
    const ConvergenceReferences references = measureCurves(renderer, planner, request, options, frames, curves);
    const std::filesystem::path folder(options.output);
    const std::string stem = std::filesystem::path(name).stem().string();
    const std::vector<int> shown = framesOfStrip(frames);
    const PixelSquare square = worstSquare(curves.front().pictures.back(), references.rayTraced, stripSide);
    std::vector<std::vector<DisplayImage>> strip;
    std::vector<std::string> variants;
    for (const ConvergenceCurve& curve : curves) {
        if (curve.afterMotion) continue;
        strip.push_back(shownInStrip(curve, frames, shown));
        variants.push_back("`" + curve.variant + "`");
    }
    writeFileAtomically(folder / (stem + ".csv"), convergenceCsv(curves, frames));
    const auto writeChart = [&](const std::string& file, ConvergenceTarget target) {
        writePng(folder / (file + ".png"), drawChart(convergenceChart(stem, curves, frames, target), 960, 640));
    };
    writeChart(stem, ConvergenceTarget::RayTraced);
    writeChart(stem + "-own", ConvergenceTarget::Own);
    writePng(folder / (stem + "-strip.png"), detailStrip(strip, square, stripZoom));
    return fmt::format(
        "\n## {0}, frame {1:g}{7}\n\n{2}\n![convergence]({0}.png)\n\nAgainst their own pictures after {5} frames:\n\n"
        "{6}\n![convergence]({0}-own.png)\n\nA detail, left to right after {3} frames; from top to bottom {4}:\n\n"
        "![strip]({0}-strip.png)\n",
        stem, request.frame, convergenceTable(curves, frames, ConvergenceTarget::RayTraced), fmt::join(shown, ", "),
        fmt::join(variants, ", "), convergedFrames, convergenceTable(curves, frames, ConvergenceTarget::Own),
        responseInTitle(request.shutter));
}

}  // namespace

int runConvergence(const MeasureOptions& options) {
    const std::vector<ConvergenceCurve> curves =
        convergenceCurves(options.measuredTechniques.empty() ? convergingTechniques() : options.measuredTechniques);
    const std::filesystem::path folder = madeFolder(options.output);
    const FolderLock lock(folder);
    std::vector<int> frames = options.convergenceFrames;
    std::sort(frames.begin(), frames.end());
    std::vector<std::string> names = options.measuredScenes;
    if (names.empty()) names = {"frusta", "chess"};
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    std::string report = head(options, renderer.device());
    for (const std::string& name : names) report += sceneSection(renderer, options, name, frames, curves);
    opengl.requireSilence();
    writeFileAtomically(folder / "report.md", report);
    fmt::print("{}\n", fullPath(folder / "report.md"));
    return 0;
}

}  // namespace timeshade
