// The compression of visibility functions: what it promises, on functions of every kind.
#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "shared/visibility_function.shared.h"

namespace timeshade {
namespace {

using shared::VisibilityWedge;

struct Jump {
    float depth, visibility;  ///< behind it
};
using Function = std::vector<Jump>;
using Nodes = std::vector<glm::vec2>;

Nodes compressed(const Function& function, float error) {
    VisibilityWedge w = shared::emptyVisibility(function.back().visibility);
    Nodes nodes;
    for (std::size_t i = 0; i < function.size(); ++i) {
        w = shared::withJump(w, function[i].depth, function[i].visibility, error, i + 1 == function.size());
        const glm::vec2 added[] = {w.new0, w.new1, w.new2};
        nodes.insert(nodes.end(), added, added + w.newNodes);
    }
    EXPECT_EQ(nodes.size(), w.nodes);
    return nodes;
}

/// What the nodes say at a depth, or in the limit just behind it.
double stored(const Nodes& nodes, float depth, bool behind) {
    const auto isBefore = [&](const glm::vec2& node) { return behind ? node.x <= depth : node.x < depth; };
    const auto next = std::find_if_not(nodes.begin(), nodes.end(), isBefore);
    if (next == nodes.begin()) return 1.0;
    if (next == nodes.end()) return static_cast<double>(nodes.back().y);
    return static_cast<double>(shared::visibilityBetween(*(next - 1), *next, depth));
}

/// Of every kind that a texel may hold: one surface whose depth the rounding of a float spreads, a few of them, a
/// cloud, a surface that moves in depth; and of every weight of its times.
Function randomFunction(std::mt19937& random) {
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const int kind = static_cast<int>(random() % 4), times = 1 + static_cast<int>(random() % 128),
              hits = 1 + static_cast<int>(random() % static_cast<unsigned>(times));
    const double scale = std::pow(10.0, number(-3.0, 3.0)), begin = number(1.0, 10.0), spread = number(0.0, 3.0);
    std::vector<float> depths;
    for (int i = 0; i < hits; ++i) {
        const double u = (i + number(0.0, 1.0)) / hits, surface = static_cast<double>(random() % 3);
        const double off = kind == 0   ? 1e-6 * begin * number(0.0, 1.0)
                           : kind == 1 ? surface
                           : kind == 2 ? number(0.0, 3.0)
                                       : spread * u + 0.01 * std::sin(20.0 * u);
        depths.push_back(static_cast<float>(scale * (begin + off)));
    }
    std::sort(depths.begin(), depths.end());
    Function function;
    float visibility = 1.0f;
    const bool even = random() % 2 == 0;
    for (std::size_t i = 0; i < depths.size(); ++i) {
        const double fall = (even ? 1.0 : number(0.0, 2.0)) / times;
        visibility = std::max(visibility - static_cast<float>(fall), 0.0f);
        if (i + 1 == depths.size() || depths[i + 1] > depths[i]) function.push_back({depths[i], visibility});
    }
    return function;
}

constexpr double rounding = 1e-6;  ///< as the header says

TEST(VisibilityFunction, IsWithinTheErrorAtEveryDepth) {
    std::mt19937 random(2000);
    std::size_t jumps = 0, kept = 0;
    for (int i = 0; i < 20000; ++i) {
        const Function function = randomFunction(random);
        const float error = i % 5 == 0 ? 0.0f : std::uniform_real_distribution(0.001f, 0.2f)(random);
        const double allowed = static_cast<double>(error) + rounding;
        const Nodes nodes = compressed(function, error);
        double before = 1.0;
        for (const Jump& jump : function) {
            // Linear between the jumps, where the function is constant: its ends bound all between.
            ASSERT_NEAR(stored(nodes, jump.depth, false), before, allowed) << i;
            before = static_cast<double>(jump.visibility);
            ASSERT_NEAR(stored(nodes, jump.depth, true), before, allowed) << i;
        }
        jumps += function.size();
        kept += nodes.size();
    }
    EXPECT_LT(kept, jumps);
}

TEST(VisibilityFunction, HasNodesAtItsJumpsAndNeverRises) {
    std::mt19937 random(2001);
    for (int i = 0; i < 20000; ++i) {
        const Function function = randomFunction(random);
        const Nodes nodes = compressed(function, i % 5 == 0 ? 0.0f : 0.03f);
        ASSERT_LE(nodes.size(), 2 * function.size());
        ASSERT_EQ(nodes.front(), glm::vec2(function.front().depth, 1.0f)) << "exact before the first";
        ASSERT_EQ(nodes.back(), glm::vec2(function.back().depth, function.back().visibility)) << "and behind the last";
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            ASSERT_GE(nodes[k].y, 0.0f);
            ASSERT_TRUE(std::any_of(function.begin(), function.end(),
                                    [&](const Jump& jump) { return jump.depth == nodes[k].x; }));
            if (k == 0) continue;
            ASSERT_GE(nodes[k].x, nodes[k - 1].x);
            ASSERT_LE(nodes[k].y, nodes[k - 1].y);
            ASSERT_NE(nodes[k], nodes[k - 1]) << "a node that says nothing";
        }
    }
}

TEST(VisibilityFunction, IsStoredWholeWithoutAnError) {
    const Nodes nodes = compressed({{1.0f, 0.75f}, {2.0f, 0.5f}, {4.0f, 0.0f}}, 0.0f);
    EXPECT_EQ(nodes, (Nodes{{1, 1}, {1, 0.75f}, {2, 0.75f}, {2, 0.5f}, {4, 0.5f}, {4, 0}}));
}

/// A caster that approaches the light through a texel: a straight fall, two nodes whatever the number of times. And a
/// surface that stands still: a jump.
TEST(VisibilityFunction, AStraightFallIsOneSegment) {
    Function fall;
    for (int i = 1; i <= 128; ++i) {
        const float share = static_cast<float>(i) / 128.0f;
        fall.push_back({2.0f + share, 1.0f - share});
    }
    EXPECT_EQ(compressed(fall, 0.03f).size(), 2u);
    EXPECT_EQ(compressed({{3.0f, 0.25f}}, 0.03f), (Nodes{{3, 1}, {3, 0.25f}}));
    EXPECT_EQ(compressed({{3.0f, 0.6f}, {5.0f, 0.0f}}, 0.03f).size(), 4u) << "two jumps stay two";
}

}  // namespace
}  // namespace timeshade
