#include "measure/effects.h"

#include <algorithm>
#include <chrono>
#include <memory>

#include <fmt/format.h>

#include "frame/frame_renderer.h"
#include "frame/warm_up.h"
#include "measure/stopwatch.h"
#include "measure/technique_variant.h"

namespace timeshade {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int uncountedFrames = 2;  // the first finds nothing cached, and caches fill in the second

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
}

/// One row while it is being played.
struct Player {
    Player(std::string effect, const std::string& technique, std::unique_ptr<const Scene> played,
           FrameRequest frameRequest)
        : scene(std::move(played)),
          planner(*scene),
          drawn(TechniqueVariant::of(technique).make({}, renderer.programs())),
          request(drawn->asked(std::move(frameRequest))) {
        row.effect = std::move(effect);
        row.technique = technique;
    }

    void play(int frame) {
        FrameRequest now = request;
        now.frame += frame;
        if (frame == 0) {
            drawVariants(renderer, planner, *drawn, request, View::Final);
            emptyCaches(renderer, *drawn);
            drawWarmUp(renderer, planner, *drawn, request, View::Final);
        }
        const Clock::time_point begin = Clock::now();
        FramePlan plan = planner.plan(now);
        const double planned = millisecondsSince(begin);
        // The planner's own decision, made once more by a memory of the same past.
        const Clock::time_point again = Clock::now();
        memory.update(plan.texels, {plan.camera, plan.light, plan.block});
        const double decided = millisecondsSince(again);
        row.dynamicCasters = std::max(row.dynamicCasters, plan.light.dynamicTriangles.count());
        row.movingSeen = std::max(row.movingSeen, plan.camera.dynamicTriangles.count());
        row.passes.clear();
        for (const PassDecision& pass : drawn->passes(plan))
            row.passes.push_back(pass.triangles > 0 ? fmt::format("{} ({})", pass.name, pass.triangles) : pass.name);
        const std::uint64_t compiled = renderer.programs().compiled();
        renderer.draw(std::move(plan), *drawn, View::Final);
        const std::vector<gl::PassTimer::Reading> readings = renderer.timer().finishFrame();
        // Something that begins to move half-way may need a program that no frame before it needed.
        if (frame < uncountedFrames || renderer.programs().compiled() != compiled) return;
        times["plan"].push_back(planned);
        times["decide"].push_back(decided);
        for (const gl::PassTimer::Reading& reading : readings)
            if (!reading.isPart()) times[reading.name].push_back(reading.milliseconds);
        times["frame"].push_back(gl::totalOf(readings));
    }

    EffectRow finish() {
        for (const auto& [name, values] : times) row.milliseconds[name] = median(values);
        for (const TechniqueStatistic& figure : drawn->statistics()) row.statistics[figure.name] = figure.value;
        row.bytes = renderer.memory().total();
        return row;
    }

    std::unique_ptr<const Scene> scene;
    FrameRenderer renderer;
    FramePlanner planner;
    MotionClassifier memory;
    std::unique_ptr<Technique> drawn;
    FrameRequest request;
    EffectRow row;
    std::map<std::string, std::vector<double>> times;
};

std::vector<bool> nonTranslatingInstances(const FramePlan& plan) {
    const MeshTopology& topology = *plan.mesh->topology;
    std::vector<bool> nonTranslating(topology.instanceCount);
    for (std::size_t i = 0; i < plan.triangles->size(); ++i)
        if ((*plan.triangles)[i].nonTranslating) nonTranslating[topology.triangleInstances[i]] = true;
    return nonTranslating;
}

}  // namespace

std::vector<EffectRow> measureEffects(const Scene& scene, const FrameRequest& request, const EffectOptions& options) {
    const FramePlan asItIs = FramePlanner(scene).plan(request);
    const double seconds = shutterTimes(scene, request).open;
    std::vector<std::unique_ptr<Player>> players;
    const auto add = [&](const char* effect, const std::string& technique, Held held, const FrameRequest& played) {
        players.push_back(std::make_unique<Player>(
            effect, technique, std::make_unique<HeldScene>(scene, held, seconds, nonTranslatingInstances(asItIs)),
            played));
    };
    FrameRequest forcedDynamic = request, closed = request;
    forcedDynamic.forceDynamic = true;
    closed.shutter.length = 0.0;
    // The scene is held; a motion that was asked for is the request's.
    FrameRequest lightHeld = request;
    lightHeld.light.heldAt =
        request.shutter.openSeconds(request.frame) * request.shutter.framesPerSecond - scene.defaults().frame;
    add("forced dynamic", options.technique, {}, forcedDynamic);
    add("unchanged", options.technique, {}, request);
    if (asItIs.motion.nonTranslatingInstances > 0)
        add("deformation and turns held", options.technique, {.deformation = true}, request);
    if (asItIs.motion.movingTriangles > 0) add("objects held", options.technique, {.objects = true}, request);
    if (asItIs.motion.lightMoves) add("light held", options.technique, {.light = true}, lightHeld);
    if (asItIs.motion.cameraMoves) add("camera held", options.technique, {.camera = true}, request);
    add("shutter closed", options.technique, {}, closed);
    add("nothing moves", options.technique, {.objects = true, .light = true, .camera = true}, lightHeld);
    for (const std::string& technique : options.compared) add("unchanged", technique, {}, request);
    // Interleaved, so that what else the machine does falls on all of them.
    for (int frame = 0; frame < options.frames; ++frame) {
        for (std::size_t i = 0; i < players.size(); ++i) {
            if (options.progress)
                options.progress(frame * static_cast<int>(players.size()) + static_cast<int>(i),
                                 options.frames * static_cast<int>(players.size()));
            players[i]->play(frame);
        }
    }
    std::vector<EffectRow> rows;
    for (const auto& player : players) rows.push_back(player->finish());
    for (EffectRow& row : rows) row.forcedShare = row.milliseconds["frame"] / rows.front().milliseconds["frame"];
    return rows;
}

std::string effectsTable(const std::vector<EffectRow>& rows) {
    std::string text =
        "| | technique | dynamic casters | dynamic seen | plan | of it motion | camera samples | shadow structure | "
        "shadow test | shading | frame ms | of nothing planned | MiB | passes |\n"
        "| --- | --- | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | ---: | --- |\n";
    for (const EffectRow& row : rows) {
        const auto time = [&](const char* name) {
            const auto found = row.milliseconds.find(name);
            return found == row.milliseconds.end() ? std::string("-") : fmt::format("{:.1f}", found->second);
        };
        text +=
            fmt::format("| {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {} | {:.2f} | {:.1f} | {} |\n", row.effect,
                        row.technique, row.dynamicCasters, row.movingSeen, time("plan"), time("decide"), time("sample"),
                        time("build"), time("lookup"), time("shade"), time("frame"), row.forcedShare,
                        static_cast<double>(row.bytes) / (1024.0 * 1024.0), fmt::join(row.passes, ", "));
    }
    return text;
}

}  // namespace timeshade
