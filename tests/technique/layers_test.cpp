// Filtered layered shadow maps: what they promise beside what holds for every technique.
#include "techniques/layers/layers_shadow.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>
#include <vector>

#include "cases/closed_form_cases.h"
#include "measure/case_matrix.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"

namespace timeshade {
namespace {

using Settings = std::vector<std::pair<const char*, const char*>>;

std::vector<float> visibilityOf(const Scene& scene, const FrameRequest& request, const Settings& settings) {
    LayersShadow technique(sharedRenderer().programs());
    for (const auto& [key, value] : settings) setFromText(technique, key, value);
    sharedRenderer().draw(FramePlanner(scene).plan(request), technique, View::Visibility);
    return sharedRenderer().readVisibility();
}

double meanDifference(const std::vector<float>& a, const std::vector<float>& b) {
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += std::abs(static_cast<double>(a[i] - b[i]));
    return sum / static_cast<double>(a.size());
}

const Scene& movingScene() {
    static const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 60, .seed = 7});
    return *scene;
}

FrameRequest movingRequest(std::uint32_t seed) { return ProceduralScene::request(64, 48, 4, 128, seed); }

/// Each part that the paper's figure 9 switches off, and each form, changes the picture, and none leaves [0, 1].
TEST(Layers, EveryPartCountsAndStaysInRange) {
    const std::vector<float> whole = visibilityOf(movingScene(), movingRequest(3), {});
    const std::vector<Settings> parts{{{"count", "1"}},      {{"count", "2"}},   {{"neighbour_tiles", "off"}},
                                      {{"v_filter", "off"}}, {{"tiles", "4x4"}}, {{"as_published", "on"}},
                                      {{"strata", "8"}},     {{"bias", "16"}}};
    for (const Settings& settings : parts) {
        const std::vector<float> values = visibilityOf(movingScene(), movingRequest(3), settings);
        EXPECT_GT(meanDifference(values, whole), 1e-6) << settings[0].first << " changes nothing";
        EXPECT_GE(*std::min_element(values.begin(), values.end()), 0.0f) << settings[0].first;
        EXPECT_LE(*std::max_element(values.begin(), values.end()), 1.0f) << settings[0].first;
    }
}

/// Equation 9 as it stands darkens receivers nearer than the mean, and lit ones are.
TEST(Layers, Equation9AloneOnlyDarkens) {
    const std::vector<float> with = visibilityOf(movingScene(), movingRequest(3), {{"as_published", "on"}});
    const std::vector<float> alone =
        visibilityOf(movingScene(), movingRequest(3), {{"as_published", "on"}, {"equation_9_alone", "on"}});
    for (std::size_t i = 0; i < with.size(); ++i) ASSERT_LE(alone[i], with[i] + 2e-3f) << i;
    EXPECT_GT(meanDifference(with, alone), 0.05);
}

/// What it is for: a quad that slides over a still receiver. Its samples all move alike, so all of them, from all
/// times, tell each camera sample about its own stratum: less noise from seed to seed than single tests have.
TEST(Layers, FilteringLeavesLessNoiseThanTheTestsThatItFilters) {
    const std::vector<ClosedFormCase>& all = closedFormCases();
    const auto found =
        std::find_if(all.begin(), all.end(), [](const auto& c) { return c.name == "quad_sweeps_point"; });
    ASSERT_NE(found, all.end());
    const auto spreadOf = [&](const Settings& settings) {
        LayersShadow technique(sharedRenderer().programs());
        for (const auto& [key, value] : settings) setFromText(technique, key, value);
        std::vector<double> lit;
        for (std::uint32_t seed = 1; seed <= 12; ++seed) {
            sharedRenderer().draw(FramePlanner(*found->scene).plan(found->request(4, 512, seed)), technique,
                                  View::Visibility);
            const std::vector<float> values = sharedRenderer().readVisibility();
            const std::size_t pixels = values.size() / 4, middle = pixels / 2;  // one layer of values a stratum
            double sum = 0.0;
            for (std::size_t k = 0; k < 4; ++k) sum += static_cast<double>(values[k * pixels + middle]);
            lit.push_back(sum / 4.0);
        }
        const double mean = std::accumulate(lit.begin(), lit.end(), 0.0) / static_cast<double>(lit.size());
        double square = 0.0;
        for (const double value : lit) square += (value - mean) * (value - mean);
        EXPECT_NEAR(mean, found->exact, 0.12);
        return std::sqrt(square / static_cast<double>(lit.size()));
    };
    // A single test a sample: .6 lit with a fixed time in each stratum leaves about .12.
    EXPECT_LT(spreadOf({}), 0.06);
}

/// Bytes follow from the sizes that the page states: 16 a cell and layer, 32 a tile and layer, 8 a block, 20 a sample.
TEST(Layers, BytesAreThoseOfItsParts) {
    LayersShadow technique(sharedRenderer().programs());
    for (const auto& [tiles, tile, grid] : {std::tuple{"8x8", 8, 16}, std::tuple{"4x4", 4, 8}}) {
        for (const int count : {4, 2}) {
            setFromText(technique, "tiles", tiles);
            setFromText(technique, "count", std::to_string(count));
            sharedRenderer().draw(FramePlanner(movingScene()).plan(movingRequest(1)), technique, View::Visibility);
            const double across = 128.0 / tile, cells = across * across * grid * grid;
            const double expected =
                16.0 * cells * count + 32.0 * across * across * 4.0 + 8.0 * 32.0 * 32.0 + 20.0 * 128.0 * 128.0 * 4.0;
            EXPECT_NEAR(static_cast<double>(technique.bytes()) / expected, 1.0, 0.05) << tiles << " " << count;
        }
    }
}

/// Opposite motions in one layer average to nothing: found by their spread, and answered by the samples themselves.
TEST(Layers, OppositeMotionsInOneLayerAreAnsweredBySamples) {
    const std::vector<ClosedFormCase>& all = closedFormCases();
    const auto found = std::find_if(all.begin(), all.end(), [](const auto& c) { return c.name == "opposite_motion"; });
    ASSERT_NE(found, all.end());
    LayersShadow technique(sharedRenderer().programs());
    EXPECT_NEAR(measureLitShare(sharedRenderer(), technique, *found, {}, 4), found->exact, 0.04);
}

}  // namespace
}  // namespace timeshade
