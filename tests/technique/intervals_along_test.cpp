// Interval shadow maps on interval samples: the share of a segment that is lit is the mean of what they say at
// instants.
#include <gtest/gtest.h>

#include <cmath>

#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "support/lit_centres.h"
#include "support/moving_scene.h"
#include "support/thorough.h"
#include "techniques/intervals/intervals_shadow.h"

namespace timeshade {
namespace {

using Settings = std::vector<std::pair<std::string, std::string>>;

constexpr int width = 64, height = 48, instants = 32;
constexpr std::uint32_t seeds = 6;

std::unique_ptr<Scene> sceneOf(const std::string& name) {
    if (name == "quads") return makeMovingScene({.seed = 3});
    return openScene(name, "");
}

FrameRequest requestOf(const Scene& scene) {
    FrameRequest request;
    request.width = width;
    request.height = height;
    request.mapSize = 128;
    request.pixelCentres = true;
    request.frame = scene.defaults().frame;
    request.shutter.framesPerSecond = scene.defaults().framesPerSecond;
    request.shutter.length = scene.defaults().shutterLength;
    return request;
}

std::vector<double> litOf(const Scene& scene, const FrameRequest& request, const Settings& settings) {
    IntervalsShadow technique(sharedRenderer().programs());
    for (const auto& [key, value] : settings) setFromText(technique, key, value);
    return litAtCentres(scene, request, technique, seeds);
}

struct Difference {
    double mean = 0.0, rms = 0.0;
};

/// Of segments from instants, over all pixels.
Difference differenceOf(const std::string& name, const Settings& settings) {
    const std::unique_ptr<Scene> scene = sceneOf(name);
    FrameRequest request = requestOf(*scene);
    request.samplesPerPixel = instants;
    const std::vector<double> sampled = litOf(*scene, request, settings);
    request.samplesPerPixel = 1;
    request.samples = CameraSamples::Intervals;
    const std::vector<double> solved = litOf(*scene, request, settings);
    Difference difference;
    for (std::size_t i = 0; i < solved.size(); ++i) {
        difference.mean += (solved[i] - sampled[i]) / static_cast<double>(solved.size());
        difference.rms += std::pow(solved[i] - sampled[i], 2.0) / static_cast<double>(solved.size());
    }
    difference.rms = std::sqrt(difference.rms);
    return difference;
}

class IntervalsAlong : public testing::TestWithParam<const char*> {
  protected:
    /// Most of it is the noise of the instants. In "quads" the light grazes the faces of bent quads, which shadow each
    /// other texel by texel: there is more of it, and chords of the receivers' ways show.
    /// As a rule each scene is drawn with one of the three settings.
    void expectAlike(std::size_t number, const Settings& settings) {
        if (!isDrawn(number + std::string(GetParam()).size())) GTEST_SKIP() << "drawn where TIMESHADE_TESTS=all";
        const Difference found = differenceOf(GetParam(), settings);
        const double scale = GetParam() == std::string("quads") ? 2.0 : 1.0;
        EXPECT_LE(std::abs(found.mean), 0.0004 * scale);
        EXPECT_LE(found.rms, 0.005 * scale);
        RecordProperty("rms", std::to_string(found.rms));
    }
};

TEST_P(IntervalsAlong, AreTheMeanOfInstants) { expectAlike(0, {}); }

TEST_P(IntervalsAlong, AreTheMeanOfInstantsFiltered) { expectAlike(1, {{"bilinear", "on"}}); }

TEST_P(IntervalsAlong, AsPublishedAreTheMeanOfInstants) {
    expectAlike(2, {{"as_published", "on"}, {"least_points", "256"}});
}

INSTANTIATE_TEST_SUITE_P(Scenes, IntervalsAlong,
                         testing::Values("pillars", "crossing", "cubes", "rising", "octopus", "chess", "quads"),
                         [](const testing::TestParamInfo<const char*>& tested) { return std::string(tested.param); });

}  // namespace
}  // namespace timeshade
