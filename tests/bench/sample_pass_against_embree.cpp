// Is drawing the camera samples slower than tracing them? The sample pass of the built-in scenes against Embree's
// motion-blurred primary rays for the very same camera samples, on the same cores: packets of eight, all threads,
// scene built once and not counted, interleaved frame by frame. Prints medians and their ratio, and checks that both
// see the same triangles. Exit code 1 when the ratio is above 1.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <thread>
#include <vector>

#include <fmt/format.h>

#include "frame/frame_renderer.h"
#include "frame_setup.h"
#include "make_context.h"
#include "measure/embree_baseline.h"
#include "report.h"
#include "scene_catalogue.h"
#include "timing.h"

using namespace timeshade;

namespace {

/// Draws the samples only; the technique is asked for nothing.
class NoShadow final : public Technique {
  public:
    const TechniqueDescription& description() const override {
        static const TechniqueDescription none{"none", "none", "none", "", "", {}, {}, {}, {}};
        return none;
    }
    void visitSettings(SettingsVisitor&) override {}
    std::vector<PassDecision> passes(const FramePlan&) const override { return {}; }
    void build(const TechniqueFrame&) override {}
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame&) override {}
    std::size_t bytes() const override { return 0; }
};

double sampleMilliseconds(FrameRenderer& renderer, const FramePlan& plan, Technique& technique) {
    renderer.draw(plan, technique, View::Visibility);
    for (const auto& reading : renderer.timer().finishFrame())
        if (reading.name == "sample") return reading.milliseconds;
    return 0.0;
}

double compare(FrameRenderer& renderer, const std::string& name, int rounds) {
    const std::unique_ptr<Scene> scene = openScene(name, "");
    FramePlanner planner(*scene);
    FrameOptions options;
    const FramePlan plan = planner.plan(requestFor(options, *scene));
    NoShadow none;
    EmbreeBaseline rays(plan);
    rays.build();
    std::vector<double> drawn, made, traced;
    for (int round = -2; round < rounds; ++round) {  // two rounds to warm up
        const double a = sampleMilliseconds(renderer, plan, none);
        const auto begin = std::chrono::steady_clock::now();
        rays.makeRays();
        const double b = millisecondsSince(begin);
        const auto beginTracing = std::chrono::steady_clock::now();
        rays.tracePrimaries();
        const double c = millisecondsSince(beginTracing);
        if (round < 0) continue;
        drawn.push_back(a);
        made.push_back(b);
        traced.push_back(c);
    }
    const std::vector<std::uint32_t> ids = renderer.readSampleIds();
    const std::vector<std::uint32_t>& tracedIds = rays.tracePrimaries();
    std::size_t different = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) different += ids[i] != tracedIds[i] ? 1u : 0u;
    const double ratio = median(drawn) / median(traced);
    fmt::print("{:<9} {:>6} triangles  {:>7.1f} ms  {:>7.1f} ms  {:>7.1f} ms  {:>5.2f}   {:>7.1f} ppm differ\n", name,
               plan.motion.triangles, median(drawn), median(traced), median(made), ratio,
               1e6 * static_cast<double>(different) / static_cast<double>(ids.size()));
    return ratio;
}

}  // namespace

int main(int argumentCount, char** arguments) {
    const int rounds = argumentCount > 1 ? std::max(1, std::atoi(arguments[1])) : 11;
    const std::unique_ptr<GlContext> context = makeContext({}, false);
    FrameRenderer renderer;
    fmt::print("{}, {} threads; 640 x 480, 8 samples per pixel; medians of {} interleaved rounds\n",
               deviceLine(renderer.device()), std::thread::hardware_concurrency(), rounds);
    fmt::print("{:<9} {:>16}  {:>10}  {:>10}  {:>10}  {:>5}\n", "scene", "", "drawn", "Embree", "its rays", "ratio");
    double worst = 0.0;
    for (const std::string& scene : showcase()) worst = std::max(worst, compare(renderer, scene, rounds));
    fmt::print("worst ratio {:.2f}; 1 is as fast as Embree\n", worst);
    return worst <= 1.0 ? 0 : 1;
}
