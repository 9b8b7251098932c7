// A light that a request places and moves, against the mean of many instants: each is a frame of its own with a closed
// shutter, for which the light is placed at that very time. What is drawn knows both ends of the shutter alone.
#include <cmath>
#include <memory>
#include <vector>

#include <gtest/gtest.h>

#include "measure/reference_technique.h"
#include "plan/frame_plan.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

FrameRequest requestOf(const Scene& scene, const LightChange& change, int samples, std::uint32_t seed) {
    FrameRequest request;
    request.width = 48;
    request.height = 36;
    request.samplesPerPixel = samples;
    request.mapSize = 256;
    request.seed = seed;
    request.frame = scene.defaults().frame + 1.0;
    request.shutter.framesPerSecond = scene.defaults().framesPerSecond;
    request.shutter.length = 1.0;
    request.light = change;
    return request;
}

std::vector<double> added(std::vector<double> sum, const LinearImage& picture) {
    sum.resize(picture.rgb.size() / 3);
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += static_cast<double>(picture.rgb[3 * i]);
    return sum;
}

double rmsOf(const std::vector<double>& a, int countA, const std::vector<double>& b, int countB) {
    double squares = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) squares += std::pow(a[i] / countA - b[i] / countB, 2.0);
    return std::sqrt(squares / static_cast<double>(a.size()));
}

/// The mean of 32 instants within the shutter.
std::vector<double> composed(const Scene& scene, const LightChange& change, int instants) {
    FramePlanner planner(scene);
    ReferenceTechnique truth;
    std::vector<double> sum;
    for (int k = 0; k < instants; ++k) {
        FrameRequest request = requestOf(scene, change, 4, 100u + static_cast<std::uint32_t>(k));
        request.shutter.length = 0.0;
        request.frame += (k + 0.5) / instants;
        sharedRenderer().draw(planner.plan(request), truth, View::Visibility);
        sum = added(std::move(sum), sharedRenderer().readRadiance());
    }
    return sum;
}

std::vector<double> drawn(const Scene& scene, const LightChange& change, int frames) {
    FramePlanner planner(scene);
    const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
    std::vector<double> sum;
    for (int k = 0; k < frames; ++k) {
        const FrameRequest request = requestOf(scene, change, 32, 500u + static_cast<std::uint32_t>(k));
        sharedRenderer().draw(planner.plan(request), *exact, View::Visibility);
        sum = added(std::move(sum), sharedRenderer().readRadiance());
    }
    return sum;
}

TEST(ChangedLight, IsTheMeanOfItsInstants) {
    const std::unique_ptr<Scene> scene = openScene("cubes", "", {{"cubes.count", "40"}, {"cubes.speed", "0"}});
    LightChange change;
    change.direction = LightDirection{35.0, 50.0};
    change.move = {2.0, 0.0, -1.0};
    change.turn = 6.0;
    constexpr int instants = 64, frames = 4;
    const std::vector<double> truth = composed(*scene, change, instants);
    EXPECT_LT(rmsOf(drawn(*scene, change, frames), frames, truth, instants), 0.03);
    LightChange placed;
    placed.direction = change.direction;
    EXPECT_GT(rmsOf(drawn(*scene, placed, frames), frames, truth, instants), 0.06) << "without its motion";
}

}  // namespace
}  // namespace timeshade
