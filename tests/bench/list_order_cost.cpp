// Does the order in which triangles come into a technique's lists cost time? 500 cubes, nothing cached, in ascending
// order, reversed and shuffled in turn: medians of structure and shadow test together. That the order changes no value
// is tested (ListOrder).
#include <algorithm>
#include <array>
#include <random>
#include <vector>

#include <fmt/format.h>

#include "frame/frame_renderer.h"
#include "frame_setup.h"
#include "make_context.h"
#include "report.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"
#include "timing.h"

using namespace timeshade;

namespace {

constexpr int rounds = 7;

double milliseconds(FrameRenderer& renderer, const FramePlan& plan, Technique& technique) {
    renderer.invalidateAll();
    renderer.draw(plan, technique, View::Visibility);
    double sum = 0.0;
    for (const auto& reading : renderer.timer().finishFrame())
        if (reading.name == "build" || reading.name == "lookup") sum += reading.milliseconds;
    return sum;
}

void compare(FrameRenderer& renderer, const std::array<FramePlan, 3>& plans, const std::string& name) {
    const std::unique_ptr<Technique> technique = makeTechnique(name, renderer.programs());
    std::array<std::vector<double>, 3> taken;
    for (int round = -1; round < rounds; ++round)  // one to warm up
        for (std::size_t i = 0; i < plans.size(); ++i) {
            const double each = milliseconds(renderer, plans[i], *technique);
            if (round >= 0) taken[i].push_back(each);
        }
    fmt::print("{:<14} {:8.1f} ms   reversed {:5.2f}   shuffled {:5.2f}\n", name, median(taken[0]),
               median(taken[1]) / median(taken[0]), median(taken[2]) / median(taken[0]));
}

}  // namespace

int main(int argumentCount, char** arguments) {
    const std::unique_ptr<GlContext> context = makeContext({}, false);
    FrameRenderer renderer;
    fmt::print("{}\n", deviceLine(renderer.device()));
    const std::unique_ptr<Scene> scene = openScene("cubes", "");
    FramePlanner planner(*scene);
    FrameOptions options;
    const FramePlan plan = planner.plan(requestFor(options, *scene));
    std::array<FramePlan, 3> plans{plan, plan, plan};
    auto& reversed = plans[1].casters.dynamicCasters;
    std::reverse(reversed.begin(), reversed.end());
    auto& shuffled = plans[2].casters.dynamicCasters;
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(3));
    std::vector<std::string> names(arguments + 1, arguments + argumentCount);
    if (names.empty())
        for (const TechniqueDescription& description : techniqueDescriptions()) names.push_back(description.name);
    for (const std::string& name : names) compare(renderer, plans, name);
    return 0;
}
