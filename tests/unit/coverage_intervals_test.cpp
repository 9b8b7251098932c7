// When a moving triangle covers a point, against many instants tested in double precision one by one.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>
#include <vector>

#include <glm/glm.hpp>

#include "shared/coverage_intervals.shared.h"

namespace timeshade {
namespace {

using Triangle = std::array<glm::dvec2, 3>;

struct Path {
    Triangle open, close;
};

/// The vertices as they are seen from `point`, all at distance 1.
shared::EdgeQuadratics quadraticsOf(const Path& path, glm::dvec2 point) {
    std::array<glm::vec2, 6> q;
    for (std::size_t i = 0; i < 3; ++i) {
        q[i] = glm::vec2(path.open[i] - point);
        q[i + 3] = glm::vec2(path.close[i] - point);
    }
    return shared::edgeQuadratics(q[0], q[1], q[2], q[3], q[4], q[5]);
}

/// 1, -1: inside, by side; 0: outside.
int exactSide(const Path& path, glm::dvec2 point, double u) {
    Triangle t;
    for (std::size_t i = 0; i < 3; ++i) t[i] = glm::mix(path.open[i], path.close[i], u) - point;
    int positive = 0, negative = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const glm::dvec2 a = t[(i + 1) % 3], b = t[(i + 2) % 3];
        const double e = a.x * b.y - a.y * b.x;
        positive += e > 0.0;
        negative += e < 0.0;
    }
    return positive > 0 && negative == 0 ? 1 : negative > 0 && positive == 0 ? -1 : 0;
}

bool within(const shared::CoverageIntervals& intervals, double u) {
    for (int i = 0; i < intervals.count; ++i)
        if (u >= static_cast<double>(intervals.begins[i]) && u <= static_cast<double>(intervals.ends[i])) return true;
    return false;
}

struct Span {
    double begin, end;
};

void expectIntervals(const Path& path, glm::dvec2 point, const std::vector<Span>& expected, double tolerance = 1e-5) {
    const shared::CoverageIntervals intervals = shared::intervalsOf(quadraticsOf(path, point));
    ASSERT_EQ(intervals.count, static_cast<int>(expected.size()));
    for (int i = 0; i < intervals.count; ++i) {
        EXPECT_NEAR(intervals.begins[i], expected[static_cast<std::size_t>(i)].begin, tolerance) << "interval " << i;
        EXPECT_NEAR(intervals.ends[i], expected[static_cast<std::size_t>(i)].end, tolerance) << "interval " << i;
    }
}

TEST(CoverageIntervals, KnownCases) {
    const double s = std::sqrt(3.0) / 2.0;
    {
        SCOPED_TRACE("bilinear sides: the swept volume's linear pieces would give .5500 to .6899");
        expectIntervals({{{{-2, -1}, {-1, -1}, {-1.5, 1}}}, {{{2, -1}, {1, 1}, {.5, -1.2}}}}, {.1, -.2},
                        {{.5397, .7082}}, 5e-5);
    }
    {
        SCOPED_TRACE("pure translation");
        const Path path{{{{-2, -1}, {-1, -1}, {-2, 1}}}, {{{1, -1}, {2, -1}, {1, 1}}}};
        expectIntervals(path, {-.25, -.25}, {{.375, .583333}});
        const shared::CoverageIntervals intervals = shared::intervalsOfTranslation(quadraticsOf(path, {-.25, -.25}));
        ASSERT_EQ(intervals.count, 1);
        EXPECT_NEAR(intervals.begins.x, .375, 1e-6);
        EXPECT_NEAR(intervals.ends.x, .583333, 1e-6);
        EXPECT_EQ(shared::intervalsOfTranslation(quadraticsOf(path, {-.25, -1.25})).count, 0);
    }
    {
        SCOPED_TRACE("collapses and turns over: two intervals");
        expectIntervals({{{{-1, -1}, {1, -1}, {0, 1}}}, {{{-1, 1.5}, {1, 1.5}, {0, -2}}}}, {0, .1},
                        {{0, .3}, {.44, 1}});
    }
    {
        SCOPED_TRACE("covered at both ends and not between");
        expectIntervals({{{{1, 0}, {-.5, s}, {-.5, -s}}}, {{{-1, 0}, {.5, -s}, {.5, s}}}}, {.2, .1},
                        {{0, .3133975}, {.7, 1}});
    }
    {
        SCOPED_TRACE("a point on the path of a vertex");
        const Path path{{{{-.1, -.1}, {.1, -.1}, {0, .1}}}, {{{-2, -2}, {2, -2}, {0, 2}}}};
        expectIntervals(path, {.7, -.7}, {{6.0 / 19.0, 1}});
    }
    {
        SCOPED_TRACE("no motion");
        expectIntervals({{{{-1, -1}, {1, -1}, {0, 1}}}, {{{-1, -1}, {1, -1}, {0, 1}}}}, {0, 0}, {{0, 1}});
        expectIntervals({{{{-1, -1}, {1, -1}, {0, 1}}}, {{{-1, -1}, {1, -1}, {0, 1}}}}, {2, 0}, {});
    }
    {
        SCOPED_TRACE("seen edge-on throughout");
        expectIntervals({{{{-1, 0}, {0, 0}, {1, 0}}}, {{{-1, 0}, {0, 0}, {1, 0}}}}, {.3, .01}, {});
        expectIntervals({{{{-1, 0}, {0, 0}, {1, 0}}}, {{{-1, 0}, {0, 0}, {1, 0}}}}, {.3, 0}, {});
    }
    {
        SCOPED_TRACE("sweeps past in a thousandth of the shutter");
        expectIntervals({{{{-500.5, -1}, {-499.5, -1}, {-500.5, 1}}}, {{{499.5, -1}, {500.5, -1}, {499.5, 1}}}},
                        {0.0, -.5}, {{.49975, .5005}}, 1e-6);
    }
}

/// Where the prism's sides are flat, twisted, crossed or nearly so: no instant may be classified wrongly except within
/// rounding of an interval's end.
TEST(CoverageIntervals, AgreeWithInstantsInDoublePrecision) {
    std::mt19937 random(20170713);
    std::uniform_real_distribution<double> place(-1.0, 1.0), size(0.05, 1.5);
    const int instants = 400;
    std::size_t wrong = 0, inside = 0, twice = 0;
    for (int n = 0; n < 20000; ++n) {
        Path path;
        for (auto* end : {&path.open, &path.close})
            for (glm::dvec2& vertex : *end)
                vertex = glm::dvec2(glm::vec2(glm::dvec2(place(random), place(random)) * size(random)));
        if (n % 4 == 1)  // translates
            for (std::size_t i = 0; i < 3; ++i) path.close[i] = path.open[i] + (path.close[0] - path.open[0]);
        if (n % 4 == 2)  // point symmetry: double roots and coefficients that cancel
            for (std::size_t i = 0; i < 3; ++i) path.close[i] = -path.open[i];
        if (n % 4 == 3) path.close[n % 3] = path.open[n % 3];
        const glm::dvec2 point(glm::vec2(place(random) * 0.5, place(random) * 0.5));
        const shared::EdgeQuadratics e = quadraticsOf(path, point);
        const shared::CoverageIntervals intervals = shared::intervalsOf(e);
        twice += intervals.count > 1;
        if (n % 4 == 1) {
            const shared::CoverageIntervals straight = shared::intervalsOfTranslation(e);
            double length = 0.0, other = 0.0;
            for (int i = 0; i < intervals.count; ++i)
                length += static_cast<double>(intervals.ends[i] - intervals.begins[i]);
            for (int i = 0; i < straight.count; ++i)
                other += static_cast<double>(straight.ends[i] - straight.begins[i]);
            EXPECT_NEAR(length, other, 2e-5) << "case " << n;
            for (int i = 0; i < instants; ++i) {
                const double u = (i + 0.5) / instants;
                EXPECT_TRUE(within(straight, u) == within(intervals, u) ||
                            exactSide(path, point, u + 2e-5) != exactSide(path, point, u - 2e-5))
                    << "case " << n;
            }
        }
        bool throughout = true;
        for (int i = 0; i < instants; ++i) {
            const double u = (i + 0.5) / instants;
            const bool truth = exactSide(path, point, u) != 0;
            throughout = throughout && truth;
            inside += truth;
            if (truth == within(intervals, u)) continue;
            // Allowed only where the exact value itself changes within rounding.
            bool near = false;
            for (const double d : {-2e-5, 2e-5})
                near = near || exactSide(path, point, u + d) != exactSide(path, point, u);
            wrong += !near;
        }
        EXPECT_TRUE(throughout || !shared::coversThroughout(e)) << "case " << n << " is claimed and not covered";
        for (int i = 0; i < intervals.count; ++i) {
            EXPECT_LE(intervals.begins[i], intervals.ends[i]);
            if (i > 0) {
                EXPECT_LE(intervals.ends[i - 1], intervals.begins[i]);
            }
        }
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(inside, 100000u);
    EXPECT_GT(twice, 50u) << "too few cases with two intervals for the test to mean anything";
}

TEST(CoverageIntervals, DistanceIsThatOfThePlaneAndStaysFinite) {
    EXPECT_FLOAT_EQ(shared::distanceAt({-1, -1}, {1, -1}, {0, 1}, {2, 4, 6}), 4.5f);
    const float edgeOn = shared::distanceAt({-1, 0}, {0, 0}, {1, 0}, {2, 4, 6});
    EXPECT_GE(edgeOn, 2.0f);
    EXPECT_LE(edgeOn, 6.0f);
}

}  // namespace
}  // namespace timeshade
