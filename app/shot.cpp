#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "compare/compared_shot.h"
#include "core/error.h"
#include "diagnostic_shot.h"
#include "frame/frame_renderer.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "gl_checks.h"
#include "headless.h"
#include "make_context.h"
#include "measure/view_scale.h"
#include "progress.h"
#include "report.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

std::filesystem::path pathOfFrame(const std::string& output, int index, int count) {
    if (count == 1) return output;
    std::filesystem::path path(output);
    return path.parent_path() / fmt::format("{}.{:04}{}", path.stem().string(), index, path.extension().string());
}

/// A technique's view comes with its scale.
DisplayImage pictureOf(FrameRenderer& renderer) {
    const DisplayImage picture = renderer.readPicture();
    return renderer.techniqueView() ? withScale(picture, *renderer.techniqueView()) : picture;
}

void write(FrameRenderer& renderer, const std::filesystem::path& path) {
    if (path.extension() == ".exr")
        writeExr(path, renderer.readRadiance());
    else
        writePng(path, pictureOf(renderer));
}

void drawWithProgress(FrameRenderer& renderer, FramePlan plan, Technique& technique, const TechniqueOptions& options) {
    renderer.begin(std::move(plan), technique, options.view, options.techniqueView);
    const Progress progress(renderer.renders());
    while (!renderer.step()) progress.update(renderer.rendersDone());
}

void sayWritten(const std::filesystem::path& path, double milliseconds, const gl::DeviceInfo& device) {
    fmt::print("{}  {:.1f} ms  {}\n", std::filesystem::absolute(path).lexically_normal().string(), milliseconds,
               deviceLine(device));
}

}  // namespace

int runShot(const ShotOptions& options) {
    if (!options.compared.empty() && (options.diagnostic != Diagnostic::None || !options.techniqueView.empty()))
        throw UsageError("--compare: shows light; expected --view final or visibility beside it");
    const int frames = options.frames.value_or(1);
    for (int i = 0; i < frames; ++i) requireWritable(pathOfFrame(options.output, i, frames));
    if (!options.json.empty()) requireWritable(options.json);
    const std::unique_ptr<Scene> scene = openScene(options.scene, options.clip, options.settings);
    FrameRequest request = requestFor(options, *scene);
    for (const std::string& note : scene->notes()) fmt::print(stderr, "timeshade: note: {}\n", note);

    const std::unique_ptr<GlContext> context = makeContext(options.context, options.debugGl);
    const DriverWatch watch(options.debugGl);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const std::unique_ptr<Technique> technique = techniqueFor(options, renderer.programs());
    FramePlanner planner(*scene);
    for (int i = 0; i < frames; ++i, request.frame += 1.0) {
        if (options.explain && i == 0) fmt::print("{}", explain(planner.plan(request), *technique, renderer.device()));
        const std::filesystem::path path = pathOfFrame(options.output, i, frames);
        if (!options.compared.empty()) {
            const ComparedShot shot = drawCompared(renderer, planner, request, options, *scene, context->backEnd());
            watch.requireSilence();
            writePng(path, shot.picture);
            if (!options.json.empty() && i + 1 == frames) writeFileAtomically(options.json, shot.manifests);
            sayWritten(path, shot.milliseconds, renderer.device());
            continue;
        }
        drawWarmUp(renderer, planner, *technique, request, options.view);
        FramePlan plan = planner.plan(request);
        std::optional<DisplayImage> diagnostic;
        if (options.diagnostic == Diagnostic::None)
            drawWithProgress(renderer, std::move(plan), *technique, options);
        else
            diagnostic = drawDiagnostic(renderer, plan, *technique, options.diagnostic);
        const auto times = renderer.timer().finishFrame();
        watch.requireSilence();
        if (options.explain && i == 0) fmt::print("{}", countedInWords(*technique));
        if (diagnostic)
            writePng(path, *diagnostic);
        else
            write(renderer, path);
        sayWritten(path, gl::totalOf(times), renderer.device());
        if (!options.json.empty() && i + 1 == frames) {
            const std::string text = manifest(renderer, *technique, options.scene, *scene, context->backEnd(), times);
            writeFileAtomically(options.json, text);
        }
    }
    return 0;
}

int runPictures(const PicturesOptions& options) {
    const std::filesystem::path folder(options.output);
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    if (failure)
        throw Error(
            fmt::format("{}: cannot be made ({}); expected a folder to write to", folder.string(), failure.message()));
    const std::unique_ptr<GlContext> context = makeContext(options.context, options.debugGl);
    FrameRenderer renderer;
    fmt::print("{} through {}\n{} at {} x {}, {} samples per pixel, map {}\n\n", deviceLine(renderer.device()),
               context->backEnd(), options.technique, options.width, options.height, options.samplesPerPixel,
               options.mapSize);
    fmt::print("{:<9} {:>9} {:>9} {:>9} {:>9} {:>9}  {}\n", "scene", "sample", "build", "lookup", "shade", "total ms",
               "picture");
    for (const BuiltInScene& builtIn : showcase()) {
        const std::filesystem::path path = folder / (builtIn.name + ".png");
        requireWritable(path);
        const std::unique_ptr<Scene> scene = openScene(builtIn.name, "");
        const std::unique_ptr<Technique> technique = techniqueFor(options, renderer.programs());
        FramePlanner planner(*scene);
        const FrameRequest request = requestFor(options, *scene);
        drawWarmUp(renderer, planner, *technique, request, options.view);
        const FramePlan plan = planner.plan(request);
        // The first draw compiles shaders and fills caches; the second is timed.
        if (technique->renders() == 1 && warmUpCount(*technique) == 0)
            renderer.draw(plan, *technique, options.view, options.techniqueView);
        renderer.timer().finishFrame();
        drawWithProgress(renderer, plan, *technique, options);
        const auto times = renderer.timer().finishFrame();
        writePng(path, pictureOf(renderer));
        fmt::print("{:<9}", builtIn.name);
        for (const auto& reading : times)
            if (!reading.isPart()) fmt::print(" {:>9.1f}", reading.milliseconds);
        fmt::print(" {:>9.1f}  {}\n", gl::totalOf(times), std::filesystem::absolute(path).lexically_normal().string());
    }
    return 0;
}

}  // namespace timeshade
