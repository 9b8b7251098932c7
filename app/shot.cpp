#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <map>

#include <fmt/format.h>

#include "compare/compared_shot.h"
#include "compare/compared_techniques.h"
#include "core/error.h"
#include "diagnostic_shot.h"
#include "frame/frame_renderer.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "headless.h"
#include "headless_gl.h"
#include "measure/frame_clock.h"
#include "measure/view_scale.h"
#include "output_path.h"
#include "progress.h"
#include "report.h"
#include "scene_catalogue.h"
#include "shot_output.h"
#include "standard_error.h"

namespace timeshade {

namespace {

/// A technique's view comes with its scale.
DisplayImage pictureOf(FrameRenderer& renderer) {
    const DisplayImage picture = renderer.readPicture();
    return renderer.techniqueView() ? withScale(picture, *renderer.techniqueView()) : picture;
}

void write(FrameRenderer& renderer, const ShotOutput& output, const std::filesystem::path& path) {
    if (path.extension() == ".exr")
        writeExr(path, renderer.readRadiance());  // a file: a pipe takes PNG
    else
        output.write(path, pictureOf(renderer));
}

void drawWithProgress(FrameRenderer& renderer, FramePlan plan, Technique& technique, const TechniqueOptions& options) {
    renderer.begin(std::move(plan), technique, options.view, options.techniqueView);
    const Progress progress(renderer.renders());
    while (!renderer.step()) progress.update(renderer.rendersDone());
}

/// The time of the picture, all renders together. A first frame says that programs were compiled in it.
void sayWritten(const ShotOutput& output, const std::filesystem::path& path, double milliseconds, bool compiled,
                const gl::DeviceInfo& device) {
    output.say(fmt::format("{}  {:.1f} ms{}  {}\n", path == "-" ? "-" : fullPath(path), milliseconds,
                           compiled ? " with compiling shaders" : "", deviceLine(device)));
}

constexpr int steadyFrames = 3;  // that `pictures` times; the last of them is the picture

double median(std::vector<double> values) {
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2), values.end());
    return values[values.size() / 2];
}

void printTimesHeader() {
    fmt::print("{:<15} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}\n", "ms", "camera", "shadow", "shadow", "", "steady",
               "cold");
    fmt::print("{:<15} {:>9} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n", "scene", "samples", "structure", "test", "shading",
               "frame", "frame", "picture");
}

/// Steps of steady frames, their total, and a cold frame's total.
void printTimes(const std::string& scene, const std::vector<ClockedFrame>& frames, const std::filesystem::path& path) {
    std::map<std::string, std::vector<double>> steady;
    double cold = 0.0;
    for (const ClockedFrame& frame : frames) {
        if (frame.state == FrameState::Cold) cold = gl::totalOf(frame.readings);
        if (frame.state != FrameState::Steady) continue;
        for (const auto& [step, milliseconds] : stepsOf(frame.readings)) steady[step].push_back(milliseconds);
    }
    fmt::print("{:<15}", scene);
    // A technique's view takes the place of shading.
    for (const char* step : {"sample", "build", "lookup", steady.count("view") > 0 ? "view" : "shade", "total"})
        fmt::print(" {:>9.1f}", median(steady.at(step)));
    fmt::print(" {:>9.1f}  {}\n", cold, fullPath(path));
}

}  // namespace

int runShot(const ShotOptions& options) {
    if (!options.compared.empty() && (options.diagnostic != Diagnostic::None || !options.techniqueView.empty()))
        throw UsageError("--compare: shows light; expected --view final or visibility beside it");
    const int frames = options.frames.value_or(1);
    const ShotOutput output(options.output, frames);
    if (!options.json.empty()) requireWritable(options.json);
    const std::unique_ptr<Scene> scene = openScene(options.scene, choiceOf(options), options.settings);
    FrameRequest request = requestFor(options, *scene);
    for (const std::string& note : scene->notes()) tellNote(note);

    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const std::unique_ptr<Technique> technique = techniqueFor(options, renderer.programs());
    request = technique->asked(request);
    FramePlanner planner(*scene);
    for (int i = 0; i < frames; ++i, request.frame += 1.0) {
        if (options.explain && i == 0) output.say(explain(planner.plan(request), *technique, renderer.device()));
        const std::filesystem::path path = output.path(i);
        std::uint64_t compiled = renderer.programs().compiled();
        if (!options.compared.empty()) {
            const ComparedShot shot = drawCompared(renderer, planner, request, options, *scene, opengl.backEnd());
            opengl.requireSilence();
            output.write(path, shot.picture);
            if (!options.json.empty() && i + 1 == frames) writeFileAtomically(options.json, shot.manifests);
            sayWritten(output, path, shot.milliseconds, renderer.programs().compiled() != compiled, renderer.device());
            continue;
        }
        drawWarmUp(renderer, planner, *technique, request, options.view);
        compiled = renderer.programs().compiled();
        FramePlan plan = planner.plan(request);
        std::optional<DisplayImage> diagnostic;
        if (options.diagnostic == Diagnostic::None)
            drawWithProgress(renderer, std::move(plan), *technique, options);
        else
            diagnostic = drawDiagnostic(renderer, plan, *technique, options.diagnostic);
        const auto times = renderer.timer().finishFrame();
        opengl.requireSilence();
        if (options.explain && i == 0) output.say(countedOfPositions(renderer) + countedInWords(*technique));
        if (diagnostic)
            output.write(path, *diagnostic);
        else
            write(renderer, output, path);
        sayWritten(output, path, gl::totalOf(times), renderer.programs().compiled() != compiled, renderer.device());
        if (!options.json.empty() && i + 1 == frames) {
            const std::string text = manifest(renderer, *technique, options.scene, *scene, opengl.backEnd(), times);
            writeFileAtomically(options.json, text);
        }
    }
    return 0;
}

int runPictures(const PicturesOptions& options) {
    const std::filesystem::path folder = madeFolder(options.output);
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    PictureOptions drawn;
    static_cast<FrameOptions&>(drawn) = options;
    static_cast<TechniqueOptions&>(drawn) = options;
    static_cast<CompareOptions&>(drawn) = options;
    const std::vector<ComparedTechnique> techniques = techniquesFor(drawn, renderer.programs());
    std::string names;
    for (const ComparedTechnique& one : techniques)
        names += (names.empty() ? "" : " | ") + one.technique->description().name;
    fmt::print("{} through {}\n{} at {} x {}, {} samples per pixel, map {}\n\n", deviceLine(renderer.device()),
               opengl.backEnd(), names, options.width, options.height, options.samplesPerPixel, options.mapSize.text());
    const PictureText text;
    printTimesHeader();
    for (const std::string& name : showcase()) {
        const std::filesystem::path path = folder / (name + ".png");
        requireWritable(path);
        const std::unique_ptr<Scene> scene = openScene(name, "");
        FramePlanner planner(*scene);
        const FrameRequest request = askedByAll(requestFor(options, *scene), techniques);
        std::vector<DisplayImage> pictures;
        for (const ComparedTechnique& one : techniques) {
            FrameClock clock(renderer, planner, options.view, options.techniqueView);
            const FrameRequest own = one.on(request);
            clock.warmUp(*one.technique, own, steadyFrames);
            const std::vector<ClockedFrame> frames = clock.time(*one.technique, own, steadyFrames);
            pictures.push_back(pictureOf(renderer));
            printTimes(techniques.size() == 1 ? name : name + ", " + one.technique->description().name, frames, path);
        }
        opengl.requireSilence();
        writePng(path, composedFor(options, options.seam, labelsOf(techniques), pictures, text));
    }
    return 0;
}

}  // namespace timeshade
