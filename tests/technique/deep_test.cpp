// Deep shadow maps: what they promise beside what holds for every technique.
#include "techniques/deep/deep_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/closed_form_cases.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"

namespace timeshade {
namespace {

std::vector<float> visibilityOf(Technique& technique, const Scene& scene, const FrameRequest& request) {
    sharedRenderer().draw(FramePlanner(scene).plan(request), technique, View::Visibility);
    return sharedRenderer().readVisibility();
}

/// Casters that move in depth and across, before each other, in a texel or over many.
const Scene& movingScene() {
    static const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 60, .seed = 7});
    return *scene;
}

FrameRequest movingRequest() { return ProceduralScene::request(64, 48, 4, 128, 3); }

double greatestDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, static_cast<double>(std::abs(a[i] - b[i])));
    return most;
}

double statistic(const Technique& technique, const std::string& name) {
    for (const TechniqueStatistic& each : technique.statistics())
        if (each.name == name) return each.value;
    ADD_FAILURE() << "no statistic " << name;
    return 0.0;
}

/// No value is further from that of all depths than the setting allows, and fewer nodes are kept the more it allows.
TEST(Deep, CompressionStaysWithinItsError) {
    DeepShadow technique(sharedRenderer().programs());
    setFromText(technique, "error", "0");
    const std::vector<float> whole = visibilityOf(technique, movingScene(), movingRequest());
    double nodes = statistic(technique, "nodes per texel in use");
    EXPECT_GT(statistic(technique, "most nodes"), 30.0);
    for (const double error : {0.01, 0.03, 0.1, 0.3}) {
        setFromText(technique, "error", std::to_string(error));
        const double most = greatestDifference(whole, visibilityOf(technique, movingScene(), movingRequest()));
        EXPECT_LE(most, error + 1e-5);
        EXPECT_GT(most, 0.3 * error) << "nothing is compressed, so the test shows nothing";
        EXPECT_LT(statistic(technique, "nodes per texel in use"), nodes);
        nodes = statistic(technique, "nodes per texel in use");
    }
}

/// Without compression a caster more darkens, or changes nothing: a texel looks at the same times as before.
TEST(Deep, ACasterMoreNeverBrightens) {
    DeepShadow technique(sharedRenderer().programs());
    const std::unique_ptr<ProceduralScene> before = makeMovingScene({.quads = 60, .seed = 7}),
                                           after = makeMovingScene({.quads = 60, .seed = 7});
    const glm::dvec3 light = after->lightOpen.position, middle = 0.5 * (light + after->bounds().centre());
    after->quads.push_back(slidingQuad(middle, middle + glm::dvec3(0.1, 0, 0), 0.3, -0.3, 0.3));
    after->finish();
    setFromText(technique, "error", "0");
    const std::vector<float> without = visibilityOf(technique, *before, movingRequest()),
                             with = visibilityOf(technique, *after, movingRequest());
    std::size_t brighter = 0, darker = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        brighter += with[i] > without[i] + 1e-5f ? 1u : 0u;
        darker += with[i] < without[i] - 1e-5f ? 1u : 0u;
    }
    EXPECT_EQ(brighter, 0u);
    EXPECT_GT(darker, 20u);
}

/// Depths that do not fit at once are drawn some rows at a time: the same values.
TEST(Deep, RowsDrawnApartAreTheSame) {
    FrameRequest request = movingRequest();
    request.mapSize = {128, 16};
    const std::size_t row = std::size_t{128} * 128 * sizeof(float);
    DeepShadow whole(sharedRenderer().programs()), parts(sharedRenderer().programs(), 5 * row + 100),
        single(sharedRenderer().programs(), 1);  // a row at a time
    const std::vector<float> expected = visibilityOf(whole, movingScene(), request);
    for (DeepShadow* other : {&parts, &single}) {
        EXPECT_TRUE(visibilityOf(*other, movingScene(), request) == expected);
        for (const char* name : {"texels in use", "nodes per texel in use", "most nodes"})
            EXPECT_EQ(statistic(*other, name), statistic(whole, name)) << name;
    }
    EXPECT_EQ(statistic(whole, "depths before compression"), 16.0 * static_cast<double>(row));
    EXPECT_EQ(statistic(parts, "depths before compression"), 5.0 * static_cast<double>(row));
    EXPECT_EQ(statistic(single, "depths before compression"), static_cast<double>(row));
}

/// A still receiver has the mean over the shutter at each of its samples: at either end of the shadow one time decides
/// over a stratum, and half a texel of the map shifts both ends alike.
TEST(Deep, StillReceiversHaveTheMeanAtEachSample) {
    const ClosedFormCase& c = closedFormCase("quad_sweeps_point");
    for (const int times : {32, 128}) {
        DeepShadow technique(sharedRenderer().programs());
        setFromText(technique, "times", std::to_string(times));
        for (const float lit : visibilityOf(technique, *c.scene, ProceduralScene::request(12, 384, 4, {1024, 256}, 1)))
            ASSERT_NEAR(lit, c.exact, 2.0 / times + 1e-5);
    }
}

/// More times, less noise: an end of the shadow is uniform in its stratum, so that the error falls as one over times.
TEST(Deep, NoiseFallsAsOneOverTheTimes) {
    const ClosedFormCase& c = closedFormCase("quad_sweeps_point");
    std::vector<double> deviations;
    for (const char* times : {"16", "64", "256"}) {
        DeepShadow technique(sharedRenderer().programs());
        setFromText(technique, "times", times);
        double sum = 0.0, squares = 0.0;
        const std::vector<float> all =
            visibilityOf(technique, *c.scene, ProceduralScene::request(12, 384, 4, {1024, 256}, 1));
        for (const float lit : all) {
            sum += static_cast<double>(lit);
            squares += static_cast<double>(lit) * static_cast<double>(lit);
        }
        const double mean = sum / static_cast<double>(all.size());
        deviations.push_back(std::sqrt(squares / static_cast<double>(all.size()) - mean * mean));
    }
    EXPECT_NEAR(std::log2(deviations[0] / deviations[2]), 4.0, 0.8);
}

TEST(Deep, WhereNothingMovesOnlyTheMapRemains) {
    ProceduralScene scene;
    scene.quads = {slidingQuad({0, 0, 0}, {0, 0, 0}, 4, -4, 4), slidingQuad({0, 0, 2}, {0, 0, 2}, 0.5, -0.5, 0.5)};
    scene.lightOpen.position = scene.lightClose.position = {0, 0, 10};
    scene.cameraOpen = scene.cameraClose = lookAt({2, -9, 7}, {0, 0, 0}, {0, 0, 1}, 0.7, 0.01);
    scene.finish();
    DeepShadow technique(sharedRenderer().programs());
    const std::vector<float> lit = visibilityOf(technique, scene, movingRequest());
    EXPECT_EQ(technique.bytes(), 0u);
    EXPECT_TRUE(technique.statistics().empty());
    EXPECT_GT(std::count(lit.begin(), lit.end(), 0.0f), 20);
    EXPECT_GT(std::count(lit.begin(), lit.end(), 1.0f), 20);
}

}  // namespace
}  // namespace timeshade
