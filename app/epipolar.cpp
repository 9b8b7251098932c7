#include "epipolar.h"

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/error.h"
#include "frame/warm_up.h"
#include "frame_setup.h"
#include "headless.h"
#include "headless_gl.h"
#include "measure/epipolar_picture.h"
#include "measure/epipolar_view.h"
#include "output_path.h"
#include "report.h"
#include "scene_catalogue.h"
#include "standard_error.h"

namespace timeshade {

namespace {

std::string samplesInWords(const std::vector<EpipolarSample>& samples) {
    std::size_t tested = 0, lit = 0;
    double byTechnique = 0.0, off = 0.0;
    for (const EpipolarSample& sample : samples) {
        off = std::max(off, sample.texelsOff);
        if (!sample.tested) continue;
        ++tested;
        lit += sample.truth ? 1 : 0;
        byTechnique += sample.lit;
    }
    return fmt::format(
        ", {} samples of the pixel, {} face the light: {:.4g} lit by the technique, {} in truth; "
        "at most {:.2g} texels off the line",
        samples.size(), tested, byTechnique, lit, off);
}

/// One line about the picture.
std::string caption(const EpipolarView& view) {
    std::set<std::uint32_t> objects;
    for (const SeenByLight& seen : view.truth)
        if (seen.triangle != NO_TRIANGLE) objects.insert(view.instances[seen.triangle]);
    const glm::dvec2 sides(view.mapSize);
    std::string text = fmt::format(
        "line {:.4f},{:.4f},{:.4f},{:.4f}, {:.4g} texels: {} object{} in truth, {} mark{} "
        "stored",
        view.line.from.x, view.line.from.y, view.line.to.x, view.line.to.y, view.line.texels(sides), objects.size(),
        objects.size() == 1 ? "" : "s", view.stored.marks.size(), view.stored.marks.size() == 1 ? "" : "s");
    return view.samples.empty() ? text : text + samplesInWords(view.samples);
}

}  // namespace

int runEpipolar(const EpipolarOptions& options) {
    requireStrata(options, "the epipolar view");
    requireOneMotionStep(options, "the epipolar view");
    requireWritable(options.output);
    if (!options.json.empty()) requireWritable(options.json);
    const std::unique_ptr<Scene> scene = openScene(options.scene, choiceOf(options), options.settings);
    const FrameRequest given = requestFor(options, *scene);
    for (const std::string& note : scene->notes()) tellNote(note);
    const HeadlessGl opengl(options);
    FrameRenderer renderer;
    renderer.setChecked(options.debugGl);
    const std::unique_ptr<Technique> technique = techniqueFor(options, renderer.programs());
    const FrameRequest request = technique->asked(given);
    FramePlanner planner(*scene);
    const FramePlan plan = planner.plan(request);
    if (options.explain) fmt::print("{}", explain(plan, *technique, renderer.device()));

    const Oracle oracle(plan);
    std::optional<glm::uvec2> pixel = options.pixel;
    MapLine line = options.line.value_or(MapLine{});
    if (pixel) {
        const std::string name = fmt::format("--pixel {},{}", pixel->x, pixel->y);
        pixel->y = plan.block.imageSize.y - 1 - pixel->y;
        const std::optional<MapLine> through = lineThroughPixel(oracle, plan, *pixel);
        if (!through) throw Error(name + ": no sample of it sees anything inside the shadow map; choose another");
        if (!options.line) line = *through;
    }
    drawWarmUp(renderer, planner, *technique, request, View::Visibility);
    const EpipolarView view = epipolarView(renderer, oracle, plan, *technique, line, pixel);
    opengl.requireSilence();
    writePng(options.output, drawEpipolarView(view, technique->description().title));
    if (!options.json.empty())
        writeFileAtomically(options.json, manifest(renderer, *technique, options.scene, *scene, opengl.backEnd(), {}));
    fmt::print("{}  {}\n", fullPath(options.output), caption(view));
    return 0;
}

}  // namespace timeshade
