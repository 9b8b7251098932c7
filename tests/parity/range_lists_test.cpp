// The lists of the technique `ranges` under random prisms: closed surfaces, the same bytes every time, memory as
// predicted.
#include <gtest/gtest.h>

#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

double figure(const Technique& technique, const std::string& name) {
    for (const TechniqueStatistic& f : technique.statistics())
        if (f.name == name) return f.value;
    throw std::logic_error("no figure " + name);
}

std::unique_ptr<Technique> ranges(bool asPublished) {
    std::unique_ptr<Technique> technique = makeTechnique("ranges", sharedRenderer().programs());
    setFromText(*technique, "as_published", asPublished ? "on" : "off");
    return technique;
}

void draw(ProceduralScene& scene, Technique& technique, int mapSize) {
    sharedRenderer().draw(FramePlanner(scene).plan(ProceduralScene::request(32, 24, 4, mapSize, 1)), technique,
                          View::Visibility);
}

/// The surface of a prism is closed and its vertices are shared to the last bit: a texel sees an even number of its
/// triangles, whatever they are.
TEST(RangeLists, NoPrismLeavesAnUnpairedFragment) {
    const int mapSize = 160;
    double pairs = 0.0, fragments = 0.0;
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const auto scene = makeMovingScene({.quads = 120, .seed = seed, .directionalLight = seed % 2 == 0});
        const std::unique_ptr<Technique> repaired = ranges(false);
        draw(*scene, *repaired, mapSize);
        EXPECT_EQ(figure(*repaired, "lists with unpaired fragments"), 0.0) << "seed " << seed;
        EXPECT_EQ(figure(*repaired, "near-plane triangles"), 0.0);
        pairs += figure(*repaired, "dynamic triangles") * mapSize * mapSize;
        fragments += figure(*repaired, "fragments");
        EXPECT_EQ(figure(*repaired, "ranges") * 2.0, figure(*repaired, "fragments"));
    }
    EXPECT_GE(pairs, 1e7);
    EXPECT_GT(fragments, 3e5);
}

TEST(RangeLists, AreTheSameEveryTime) {
    const auto scene = makeMovingScene({.quads = 200, .seed = 5});
    for (const bool asPublished : {false, true}) {
        std::vector<float> first;
        for (int time = 0; time < 3; ++time) {
            const std::unique_ptr<Technique> technique = ranges(asPublished);
            draw(*scene, *technique, 256);
            const std::vector<float> lit = sharedRenderer().readVisibility();
            if (first.empty())
                first = lit;
            else
                EXPECT_EQ(first, lit) << (asPublished ? "published" : "repaired");
        }
    }
}

/// Equation 2 of Hong and Oh 2019, with each form's sizes: the sizes predicted from the counts are those allocated.
TEST(RangeLists, TakeTheMemoryThatEquationTwoPredicts) {
    for (const bool asPublished : {false, true}) {
        for (const int mapSize : {256, 512}) {
            const auto scene = makeMovingScene({.quads = 200, .seed = 6});
            const std::unique_ptr<Technique> technique = ranges(asPublished);
            draw(*scene, *technique, mapSize);
            const double foretold = figure(*technique, "memory by equation 2"),
                         held = static_cast<double>(technique->bytes());
            EXPECT_NEAR(held / foretold, 1.0, 0.05) << (asPublished ? "published" : "repaired") << ", map " << mapSize;
            EXPECT_GT(figure(*technique, "fragments"), 1e5);
        }
    }
}

}  // namespace
}  // namespace timeshade
