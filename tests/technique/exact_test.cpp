// `exact` is right whatever its grid: the same lit values for every number of cells and buckets, every map, and for
// lists that had to be made coarser; and it agrees with the oracle in scenes where everything moves.
#include <algorithm>
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "frame/frame_renderer.h"
#include "measure/verification.h"
#include "passes/candidate_grid.h"
#include "scene_catalogue.h"
#include "support/crowded_scene.h"
#include "support/drawn_here.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

struct Kind {
    const char* name;
    bool cameraTurns, directional;
};

class Exact : public testing::TestWithParam<Kind> {};

TEST_P(Exact, AgreesWithTheOracle) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 40,
                                                                        .seed = seed,
                                                                        .cameraTurns = GetParam().cameraTurns,
                                                                        .directionalLight = GetParam().directional});
        const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(96, 72, 4, 128, seed));
        const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
        const Verification v = verifyFrame(sharedRenderer(), plan, *exact, {});
        EXPECT_GT(v.tested, 200u);
        EXPECT_EQ(v.disagree(), v.marginal)
            << "seed " << seed << ": " << v.falseShadow << " false shadow, " << v.falseLit << " false lit";
        EXPECT_LE(v.disagree(), 1u + v.tested / 20000u);
    }
}

TEST_P(Exact, GridAndMapChangeNothing) {
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene(
        {.quads = 40, .seed = 9, .cameraTurns = GetParam().cameraTurns, .directionalLight = GetParam().directional});
    std::vector<float> first;
    const auto draw = [&](int mapSize, const char* side, const char* buckets) {
        const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(96, 72, 4, mapSize, 9));
        const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
        setFromText(*exact, "side", side);
        setFromText(*exact, "buckets", buckets);
        sharedRenderer().draw(plan, *exact, View::Visibility);
        const std::vector<float> lit = sharedRenderer().readVisibility();
        if (first.empty()) first = lit;
        EXPECT_EQ(lit, first) << "map " << mapSize << ", side " << side << ", buckets " << buckets;
    };
    for (const int mapSize : {64, 1024}) draw(mapSize, "0", "0");
    for (const char* side : {"1", "7", "64", "200", "1024"}) draw(256, side, "4");
    for (const char* buckets : {"1", "2", "3", "8", "31", "32"}) draw(256, "64", buckets);
}

INSTANTIATE_TEST_SUITE_P(Kinds, Exact,
                         testing::Values(Kind{"camera_moves", false, false}, Kind{"camera_turns", true, false},
                                         Kind{"sun", false, true}),
                         [](const auto& p) { return std::string(p.param.name); });

std::size_t statisticOf(const Technique& exact, const std::string& name) {
    const std::vector<TechniqueStatistic> statistics = exact.statistics();
    return static_cast<std::size_t>(
        std::find_if(statistics.begin(), statistics.end(), [&](const TechniqueStatistic& figure) {
            return figure.name == name;
        })->value);
}

class ExactLists : public DrawnHere<CrowdedSceneOptions> {};

/// Triangles are culled only where they cannot change a picture.
TEST_P(ExactLists, CullOnlyWhatMakesNoDifference) {
    std::size_t facingAway = 0;
    for (const std::uint32_t seed : {0u, 1u, 2u, 3u}) {
        CrowdedSceneOptions options = GetParam();
        options.seed += 100 * seed;
        const std::unique_ptr<Scene> scene = makeCrowdedScene(options);
        FrameRequest request = ProceduralScene::request(160, 120, 4, 128, seed);
        request.frame = static_cast<double>(seed);
        const FramePlan plan = FramePlanner(*scene).plan(request);
        const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
        const Verification v = verifyFrame(sharedRenderer(), plan, *exact, {});
        EXPECT_GT(v.tested, 2000u);
        EXPECT_EQ(v.disagree(), v.marginal)
            << "seed " << options.seed << ": " << v.falseShadow << " false shadow, " << v.falseLit << " false lit";
        EXPECT_LE(v.disagree(), 2u + v.tested / 20000u);
        facingAway += statisticOf(*exact, "culled: facing away");
        EXPECT_EQ(statisticOf(*exact, "culled: no receiver behind") > 0u, options.overTheGround);
        setFromText(*exact, "list_all", "on");
        EXPECT_EQ(verifyFrame(sharedRenderer(), plan, *exact, {}).shadowed, v.shadowed);
        EXPECT_EQ(statisticOf(*exact, "culled: facing away") + statisticOf(*exact, "culled: no receiver behind"), 0u);
    }
    EXPECT_GT(facingAway, 1500u);
}

INSTANTIATE_TEST_SUITE_P(Crowds, ExactLists,
                         testing::Values(CrowdedSceneOptions{1}, CrowdedSceneOptions{2, true},
                                         CrowdedSceneOptions{3, false, true}, CrowdedSceneOptions{4, true, true},
                                         CrowdedSceneOptions{5, false, false, true},
                                         CrowdedSceneOptions{6, false, false, false, true},
                                         CrowdedSceneOptions{7, false, false, false, false, true},
                                         CrowdedSceneOptions{8, true, false, false, false, true}));

/// With TIMESHADE_FULL_SIZE set: pictures at the program's default size, and all grids.
/// Takes minutes.
bool atFullSize() { return std::getenv("TIMESHADE_FULL_SIZE") != nullptr; }

class ExactOnScenes : public testing::TestWithParam<const char*> {};

TEST_P(ExactOnScenes, GridAndMapChangeNothing) {
    const std::unique_ptr<Scene> scene = openScene(GetParam(), "");
    std::vector<float> first;
    const auto draw = [&](int mapSize, int buckets) {
        FrameRequest request;
        request.width = atFullSize() ? 640 : 160;
        request.height = request.width / 4 * 3;
        request.samplesPerPixel = atFullSize() ? 8 : 4;
        request.frame = scene->defaults().frame;
        request.shutter = {scene->defaults().framesPerSecond, scene->defaults().shutterLength, ShutterPosition::Start};
        request.mapSize = mapSize;
        const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
        setFromText(*exact, "side", std::to_string(mapSize));  // the cost model rarely wants the finest
        setFromText(*exact, "buckets", std::to_string(buckets));
        sharedRenderer().draw(FramePlanner(*scene).plan(request), *exact, View::Visibility);
        const std::vector<float> lit = sharedRenderer().readVisibility();
        if (first.empty()) first = lit;
        EXPECT_TRUE(lit == first) << "map " << mapSize << ", buckets " << buckets;
    };
    const std::vector<int> maps = atFullSize() ? std::vector<int>{64, 128, 256, 512, 1024} : std::vector<int>{64, 512};
    const std::vector<int> buckets = atFullSize() ? std::vector<int>{1, 2, 4, 8, 16} : std::vector<int>{1, 16};
    for (const int mapSize : maps)
        for (const int count : buckets) draw(mapSize, count);
}

INSTANTIATE_TEST_SUITE_P(Three, ExactOnScenes, testing::Values("chess", "octopus", "pillars"),
                         [](const auto& given) { return std::string(given.param); });

/// Lists that do not fit are made with larger cells, and hold every triangle that may cast a shadow there.
TEST(CandidateGrid, GrowsCoarserUntilItsListsFit) {
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 40, .seed = 4});
    const FramePlan plan = FramePlanner(*scene).plan(ProceduralScene::request(96, 72, 4, 256, 4));
    const std::unique_ptr<Technique> exact = makeTechnique("exact", sharedRenderer().programs());
    sharedRenderer().draw(plan, *exact, View::Visibility);  // leaves the frame's uniforms and the mesh bound
    CandidateGrid grid(sharedRenderer().programs());
    gl::LateCounts counts;
    grid.build(plan, plan.casters.dynamicCasters, {256, 4, 0.0, 0.0}, counts);
    EXPECT_FALSE(grid.coarsened());
    const std::size_t entries = grid.entries();
    grid.build(plan, plan.casters.dynamicCasters, {256, 4, 0.0, 0.0}, counts, entries / 3);
    EXPECT_TRUE(grid.coarsened());
    EXPECT_LT(grid.side(), 256);
    EXPECT_LE(grid.entries(), entries / 3);
    EXPECT_GT(grid.entries(), 0u);
}

}  // namespace
}  // namespace timeshade
