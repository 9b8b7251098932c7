// Lists of segments compared: what is within the tolerances agrees, and every kind of wrong list is found.
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "core/error.h"
#include "measure/segment_comparison.h"
#include "scene_catalogue.h"

namespace timeshade {
namespace {

using Cause = SegmentDisagreement::Cause;
using Segments = std::vector<SeenSegment>;

const Segments truth{{3, 0.0, 0.25}, {NO_TRIANGLE, 0.25, 0.5}, {7, 0.5, 1.0}};

SegmentComparison compareOne(const Segments& got, const std::vector<Segments>& nearby = {},
                             SegmentOracle::Doubt doubt = SegmentOracle::Doubt::None) {
    const std::vector<Segments> gots{got}, truths{truth};
    return compareSegments(gots, truths, {},
                           {[&](std::size_t) { return nearby; },
                            [&](std::size_t, double, std::uint32_t, std::uint32_t) { return doubt; }});
}

TEST(SegmentComparison, WhatIsWithinTheToleranceAgrees) {
    EXPECT_TRUE(compareOne(truth).disagreements.empty());
    EXPECT_EQ(compareOne(truth).differingTime, 0.0);
    const Segments late{{3, 0.0, 0.25 + 9e-6}, {NO_TRIANGLE, 0.25 + 9e-6, 0.5 - 9e-6}, {7, 0.5 - 9e-6, 1.0}};
    EXPECT_TRUE(compareOne(late).disagreements.empty());
    EXPECT_NEAR(compareOne(late).differingTime, 18e-6, 1e-15);
    // Segments that only one of the lists has.
    const Segments more{{3, 0.0, 0.1},      {8, 0.1, 0.1 + 9e-6}, {3, 0.1 + 9e-6, 0.25}, {NO_TRIANGLE, 0.25, 0.5},
                        {7, 0.5, 0.999995}, {3, 0.999995, 1.0}};
    EXPECT_TRUE(compareOne(more).disagreements.empty());
    // Segments without length, and neighbours with one triangle.
    const Segments cut{{3, 0.0, 0.25}, {9, 0.25, 0.25}, {NO_TRIANGLE, 0.25, 0.5}, {7, 0.5, 0.6}, {7, 0.6, 1.0}};
    EXPECT_TRUE(compareOne(cut).disagreements.empty());
    EXPECT_EQ(compareOne(cut).partsPerMillion(), 0.0);
}

TEST(SegmentComparison, WrongListsAreFound) {
    const Segments late{{3, 0.0, 0.25 + 2e-5}, {NO_TRIANGLE, 0.25 + 2e-5, 0.5}, {7, 0.5, 1.0}};
    const SegmentComparison one = compareOne(late);
    ASSERT_EQ(one.disagreements.size(), 1u);
    EXPECT_EQ(one.disagreements[0].cause, Cause::Different);
    EXPECT_EQ(one.disagreements[0].u0, 0.25);
    EXPECT_EQ(one.disagreements[0].u1, 0.25 + 2e-5);
    EXPECT_EQ(one.disagreements[0].got, 3u);
    EXPECT_EQ(one.disagreements[0].truth, NO_TRIANGLE);
    EXPECT_EQ(one.partsPerMillion(), 1e6);
    const Segments wrong{{3, 0.0, 0.25}, {8, 0.25, 0.5}, {7, 0.5, 1.0}}, missing{{3, 0.0, 0.5}, {7, 0.5, 1.0}},
        swapped{{7, 0.0, 0.25}, {NO_TRIANGLE, 0.25, 0.5}, {3, 0.5, 1.0}}, all{{NO_TRIANGLE, 0.0, 1.0}};
    for (const Segments& list : {wrong, missing, swapped, all}) EXPECT_EQ(compareOne(list).count(Cause::Different), 1u);
    // The longest part is named.
    EXPECT_EQ(compareOne(all).disagreements[0].u0, 0.5);
    EXPECT_EQ(compareOne(all).disagreements[0].truth, 7u);
}

TEST(SegmentComparison, ListsThatAreNoPartitionAreFound) {
    const Segments none, gap{{3, 0.0, 0.25}, {7, 0.5, 1.0}}, overlap{{3, 0.0, 0.6}, {7, 0.5, 1.0}}, late{{3, 0.1, 1.0}},
        early{{3, 0.0, 0.9}}, backward{{3, 0.0, 0.7}, {4, 0.7, 0.6}, {5, 0.6, 1.0}},
        noNumber{{3, 0.0, std::nan("")}, {7, std::nan(""), 1.0}};
    for (const Segments& list : {none, gap, overlap, late, early, backward, noNumber}) {
        EXPECT_FALSE(isPartition(list));
        ASSERT_EQ(compareOne(list).count(Cause::Malformed), 1u);
        EXPECT_EQ(compareOne(list).partsPerMillion(), 1e6);
    }
    EXPECT_TRUE(isPartition(truth));
}

TEST(SegmentComparison, PositionsBesideAndDoubtsAreToldApart) {
    const Segments late{{3, 0.0, 0.3}, {NO_TRIANGLE, 0.3, 0.5}, {7, 0.5, 1.0}};
    const Segments later{{3, 0.0, 0.31}, {NO_TRIANGLE, 0.31, 0.5}, {7, 0.5, 1.0}};
    const SegmentComparison beside = compareOne(late, {later});
    EXPECT_TRUE(beside.disagreements.empty());
    EXPECT_EQ(beside.beside, 1u);
    EXPECT_EQ(compareOne(later, {late}).disagreements.size(), 1u);
    const SegmentComparison tied = compareOne(late, {}, SegmentOracle::Doubt::DepthTie);
    EXPECT_EQ(tied.count(Cause::DepthTie), 1u);
    EXPECT_EQ(tied.partsPerMillion(), 0.0);
    EXPECT_EQ(compareOne(late, {}, SegmentOracle::Doubt::EdgeOn).count(Cause::EdgeOn), 1u);
    const std::vector<Segments> two{late, late}, three{late, late, late};
    EXPECT_THROW(compareSegments(two, three, {}, {}), Error);
}

/// A floor, a slow wall, a fast one and two in one plane.
struct Walls {
    Walls() {
        scene.quads.push_back(slidingQuad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 4.0, -4.0, 4.0));
        scene.quads.push_back(slidingQuad({-2.0, 0.0, 1.0}, {-2.0 + 1e-6, 0.0, 1.0}, 1.0, -4.0, 4.0));
        scene.quads.push_back(slidingQuad({0.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, 0.25, -4.0, 4.0));
        scene.quads.push_back(slidingQuad({2.5, 0.0, 0.5}, {2.6, 0.0, 0.5}, 0.5, -4.0, 4.0));
        scene.quads.push_back(slidingQuad({2.6, 0.0, 0.5}, {2.5, 0.0, 0.5}, 0.5, -4.0, 4.0));
        scene.cameraOpen = scene.cameraClose = lookAt({0.0, 0.0, 6.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.8, 0.01);
        scene.lightOpen.position = scene.lightClose.position = {0.0, 0.0, 10.0};
        scene.finish();
        planner = std::make_unique<FramePlanner>(scene);
        plan = planner->plan(ProceduralScene::request(200, 100, 1, 64, 1));
        for (float x = 0.6f; x < 200.0f; x += 3.0f) places.emplace_back(x, 40.3f);
    }
    ProceduralScene scene;
    std::unique_ptr<FramePlanner> planner;
    FramePlan plan;
    std::vector<glm::vec2> places;
};

TEST(SegmentComparison, WithTheOracle) {
    const Walls walls;
    const SegmentOracle oracle(walls.plan);
    const std::vector<Segments> right = oracle.seenByAll(walls.plan, walls.places);
    EXPECT_TRUE(compareSegments(oracle, walls.plan, walls.places, right).disagreements.empty());

    // Every boundary too late: found at each place that has one.
    std::vector<Segments> late = right;
    std::size_t moved = 0;
    for (Segments& list : late) {
        for (std::size_t i = 0; i + 1 < list.size(); ++i) list[i + 1].u0 = list[i].u1 += 0.4 * (1.0 - list[i].u1);
        moved += list.size() > 1 ? 1 : 0;
    }
    const SegmentComparison comparison = compareSegments(oracle, walls.plan, walls.places, late);
    EXPECT_GT(moved, 10u);
    EXPECT_EQ(comparison.disagreements.size(), moved);
    EXPECT_GT(comparison.count(Cause::Different), moved / 2);
}

/// Half of the edge's slow way is less than 1/2000 of a pixel: whatever is said of the time, it agrees.
TEST(SegmentComparison, SlowEdgesAgreeWithinAShareOfAPixel) {
    const Walls walls;
    const SegmentOracle oracle(walls.plan);
    // The wall's right edge, x = -1 at z = 1, from the eye at z = 6, in the middle of its way.
    const double scale = 50.0 / std::tan(0.4), edge = 100.0 + scale * (-1.0 + 0.5e-6) / 5.0;
    const std::vector<glm::vec2> places{{static_cast<float>(edge), 40.3f}, {static_cast<float>(edge) - 0.01f, 40.3f}};
    const std::vector<Segments> seen = oracle.seenByAll(walls.plan, places);
    const std::uint32_t floor = seenAt(oracle.seenBy(walls.plan, {static_cast<float>(edge) + 0.3f, 40.3f}), 0.5);
    const std::vector<Segments> got{{{floor, 0.0, 1.0}}, {{floor, 0.0, 1.0}}};
    ASSERT_NE(seenAt(seen[1], 0.5), floor);
    const SegmentComparison comparison = compareSegments(oracle, walls.plan, places, got);
    ASSERT_EQ(comparison.disagreements.size(), 1u);
    EXPECT_EQ(comparison.disagreements[0].position, 1u);
}

/// Two in one plane: which of them is seen is known, but a float may take the other.
TEST(SegmentComparison, TiesOfDepthAreNamed) {
    const Walls walls;
    const SegmentOracle oracle(walls.plan);
    const double scale = 50.0 / std::tan(0.4);
    const std::vector<glm::vec2> places{{static_cast<float>(100.0 + scale * 2.55 / 5.5), 40.3f}};
    const Segments seen = oracle.seenBy(walls.plan, places[0]);
    ASSERT_EQ(seen.size(), 1u);
    EXPECT_EQ(seen[0].triangle / 2, 3u) << "the one with the lower number";
    std::vector<Segments> got{{{seen[0].triangle + 2, 0.0, 1.0}}};
    const SegmentComparison comparison = compareSegments(oracle, walls.plan, places, got);
    EXPECT_EQ(comparison.count(Cause::DepthTie), 1u);
    EXPECT_EQ(comparison.partsPerMillion(), 0.0);
    got[0][0].triangle = NO_TRIANGLE;
    EXPECT_EQ(compareSegments(oracle, walls.plan, places, got).count(Cause::Different), 1u);
}

/// Lists of positions that are a third of a pixel's 1/1000 off agree on a real scene; those of 1/50 do not.
TEST(SegmentComparison, PositionsThatAreLittleOffAgree) {
    const std::unique_ptr<Scene> scene = openScene("cubes", "");
    FrameRequest request;
    request.width = 160;
    request.height = 120;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    const SegmentOracle oracle(plan);
    std::mt19937 random(9);
    std::uniform_real_distribution<float> x(0.0f, 160.0f), y(0.0f, 120.0f), turn(0.0f, 6.2831853f);
    std::vector<glm::vec2> places;
    std::vector<Segments> near, far;
    for (int i = 0; i < 1500; ++i) {
        const float left = x(random), low = y(random);
        const auto angle = static_cast<double>(turn(random));
        const glm::dvec2 way(std::cos(angle), std::sin(angle));
        places.emplace_back(left, low);
        near.push_back(oracle.seenBy(plan, places.back(), way / 3000.0));
        far.push_back(oracle.seenBy(plan, places.back(), way / 50.0));
    }
    const SegmentComparison close = compareSegments(oracle, plan, places, near);
    const SegmentComparison off = compareSegments(oracle, plan, places, far);
    std::printf("1/3000 pixel off: %zu beside, %zu disagree; 1/50: %zu, %zu\n", close.beside,
                close.disagreements.size(), off.beside, off.disagreements.size());
    EXPECT_GT(close.beside, 100u);
    EXPECT_LE(close.disagreements.size(), 2u);
    EXPECT_GT(off.count(Cause::Different), 100u);
}

}  // namespace
}  // namespace timeshade
