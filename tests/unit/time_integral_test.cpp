// Unions of shadowed times in floats, as the GPU computes them, against double precision of its own code.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <random>
#include <vector>

#include "shared/time_integral.shared.h"
#include "support/awkward_numbers.h"
#include "support/shadowed_times.h"

namespace timeshade {
namespace {

using glm::dvec3;
using glm::vec3;
using shared::MotionPiece;
using shared::TimeUnion;

const shared::PieceTicks whole{0.0f, TICKS, 0.0f, TICKS};

/// With TIMESHADE_MANY set: minutes.
int motionsOf(int usual) { return std::getenv("TIMESHADE_MANY") != nullptr ? 5000000 : usual; }

ShadowedTimes::Motion inDouble(const MotionPiece& p) {
    return {{dvec3(p.lightOpen), dvec3(p.lightClose)},
            {{dvec3(p.open0), dvec3(p.close0)}, {dvec3(p.open1), dvec3(p.close1)}, {dvec3(p.open2), dvec3(p.close2)}},
            static_cast<double>(p.clearance)};
}

/// A triangle that passes between a receiver and the light, or near there.
MotionPiece awkwardMotion(AwkwardNumbers& numbers, unsigned motion) {
    const auto any = [&] {
        return SegmentAndTriangle{numbers.point(), {numbers.point(), numbers.point(), numbers.point()}};
    };
    const bool plain = !numbers.oneIn(3);
    const SegmentAndTriangle a = plain ? any() : awkwardSegmentAndTriangle(numbers);
    SegmentAndTriangle b = plain ? any() : numbers.oneIn(2) ? awkwardSegmentAndTriangle(numbers) : a;
    if (numbers.oneIn(3)) {  // a translation
        const vec3 way = numbers.point();
        for (int i = 0; i < 3; ++i) b.v[i] = a.v[i] + way;
    } else if (numbers.oneIn(3)) {  // hardly a motion
        for (int i = 0; i < 3; ++i) b.v[i] = numbers.near(a.v[i]);
    }
    MotionPiece p{a.toLight, b.toLight, a.v[0], a.v[1], a.v[2], b.v[0], b.v[1], b.v[2], 1e-6f};
    if (motion != MOTION_ALL && motion != MOTION_LIGHT) p.lightClose = p.lightOpen;
    if (motion <= MOTION_LIGHT) p.close0 = p.open0, p.close1 = p.open1, p.close2 = p.open2;
    return p;
}

struct Comparison {
    double meanError = 0.0;  ///< of motions without doubt
    long compared = 0, wrong = 0, empty = 0, whole = 0;
};

Comparison compare(unsigned motion, int count, std::uint32_t seed) {
    AwkwardNumbers numbers(seed);
    Comparison c;
    for (int i = 0; i < count; ++i) {
        TimeUnion u = shared::emptyTimeUnion();
        std::vector<ShadowedTimes::Interval> truth, doubtful;
        for (unsigned casters = 1 + numbers.below(3); casters > 0; --casters) {
            const MotionPiece p = awkwardMotion(numbers, motion);
            const ShadowedTimes times(inDouble(p));
            for (const auto& interval : times.intervals()) truth.push_back(interval);
            for (const auto& interval : times.doubtful()) doubtful.push_back(interval);
            u = shared::withShadow(u, p, whole, motion);
        }
        if (u.full != 0) continue;
        const double exact = ShadowedTimes::measure(truth), allowed = ShadowedTimes::measure(doubtful) + 2e-6;
        const double error = std::abs(static_cast<double>(u.covered / TICKS) - exact);
        if (error > allowed && c.wrong++ == 0)
            ADD_FAILURE() << "motions " << i << ": " << u.covered / TICKS << " for " << exact << ", " << allowed
                          << " allowed";
        if (allowed > 1e-3) continue;
        ++c.compared;
        c.meanError += error;
        c.empty += exact == 0.0;
        c.whole += exact == 1.0;
    }
    c.meanError /= static_cast<double>(c.compared);
    return c;
}

class TimeIntegral : public testing::TestWithParam<unsigned> {};

TEST_P(TimeIntegral, IsTheDoubleUnion) {
    const int count = motionsOf(100000);
    const Comparison c = compare(GetParam(), count, 100 + GetParam());
    EXPECT_EQ(c.wrong, 0);
    EXPECT_LE(c.meanError, 1e-6);
    std::printf("motion %u: %ld of %d compared, mean error %.2e, empty %ld, whole %ld\n", GetParam(), c.compared, count,
                c.meanError, c.empty, c.whole);
    EXPECT_GT(c.compared, count / 3);
    EXPECT_LT(c.empty, c.compared * 9 / 10);
}

INSTANTIATE_TEST_SUITE_P(Motions, TimeIntegral, testing::Values(MOTION_NONE, MOTION_LIGHT, MOTION_SCENE, MOTION_ALL));

/// V = W + e0 + e1 + e2 with the light as the origin of V: here W - V = -(e0 + e1 + e2) as coefficients, edges being
/// twice the determinants.
TEST(ShadowSigns, PlaneAndEdgesAreOneIdentity) {
    AwkwardNumbers numbers(7);
    for (int i = 0; i < 100000; ++i) {
        MotionPiece p = awkwardMotion(numbers, MOTION_ALL);
        p.clearance = 0.0f;
        const shared::ShadowSigns s = shared::shadowSigns(p, MOTION_ALL);
        const glm::dvec4 edges = 0.5 * (glm::dvec4(s.edge0) + glm::dvec4(s.edge1) + glm::dvec4(s.edge2));
        const glm::dvec4 through = glm::dvec4(s.plane) - glm::dvec4(s.beyond);
        double largest = 0.0;
        for (const vec3& v : {p.open0, p.open1, p.open2, p.close0, p.close1, p.close2})
            largest = std::max(largest, glm::length(dvec3(v)));
        largest *= largest * std::max(glm::length(dvec3(p.lightOpen)), glm::length(dvec3(p.lightClose)));
        largest += std::abs(static_cast<double>(shared::mostOf(glm::abs(s.plane))));
        for (int k = 0; k < 4; ++k) ASSERT_NEAR(edges[k], through[k], std::ldexp(largest, -18)) << i << ", " << k;
    }
}

/// Neighbours change sides of their edge at one time: the union of both has no gap there.
TEST(TimeIntegral, NeighboursLeaveNoGap) {
    AwkwardNumbers numbers(11);
    for (int i = 0; i < 20000; ++i) {
        const MotionPiece p = awkwardMotion(numbers, MOTION_ALL);
        const vec3 a = shared::changeTimes(
                       shared::edgeCoefficients(p, p.open0, p.open1, p.close0, p.close1, MOTION_ALL), 3u),
                   b = shared::changeTimes(
                       shared::edgeCoefficients(p, p.open1, p.open0, p.close1, p.close0, MOTION_ALL), 3u);
        ASSERT_EQ(a, b) << i;
    }
}

/// A triangle of either orientation that rises through the receiver's plane shadows it from the clearance on.
TEST(TimeIntegral, BeginsWhereTheClearanceEnds) {
    MotionPiece p;
    p.lightOpen = p.lightClose = vec3(0, 0, 10);
    p.open0 = vec3(-1, -1, -1), p.open1 = vec3(1, -1, -1), p.open2 = vec3(0, 1, -1);
    p.clearance = 0.25f;
    for (const bool turned : {false, true}) {
        if (turned) std::swap(p.open0, p.open1);
        const vec3 way(0, 0, 2);
        p.close0 = p.open0 + way, p.close1 = p.open1 + way, p.close2 = p.open2 + way;
        const TimeUnion u = shared::withShadow(shared::emptyTimeUnion(), p, whole, MOTION_ALL);
        EXPECT_NEAR(u.covered / TICKS, 0.375f, 1e-6f);
        EXPECT_EQ(u.covered, shared::mostOf(u.end0) - u.begin0.x);
    }
}

/// What is wanted of a piece in parts is what is found in it at once: no part adds or loses a tick.
TEST(TimeIntegral, PartsAreTheWhole) {
    AwkwardNumbers numbers(13);
    for (int i = 0; i < 20000; ++i) {
        const unsigned motion = numbers.below(4);
        const MotionPiece p = awkwardMotion(numbers, motion);
        const float all = shared::withShadow(shared::emptyTimeUnion(), p, whole, motion).covered;
        const float cut = std::floor(numbers.unit() * TICKS);
        float sum = 0.0f;
        for (const auto& [from, to] : {std::pair(0.0f, cut), std::pair(cut, TICKS)})
            sum += shared::withShadow(shared::emptyTimeUnion(), p, {0.0f, TICKS, from, to}, motion).covered;
        ASSERT_EQ(sum, all) << i << ", motion " << motion;
    }
}

/// The stated bound holds.
TEST(TimeIntegral, IsAsRightAsItSays) {
    AwkwardNumbers numbers(17);
    for (int i = 0; i < 50000; ++i) {
        const unsigned motion = MOTION_SCENE + numbers.below(2);
        const MotionPiece p = awkwardMotion(numbers, motion);
        const double exact = ShadowedTimes::measure(ShadowedTimes(inDouble(p)).intervals());
        const TimeUnion u = shared::withShadow(shared::emptyTimeUnion(), p, whole, motion);
        const double error = std::abs(static_cast<double>(u.covered / TICKS) - exact);
        ASSERT_LE(error, static_cast<double>(shared::shadowDoubt(p, motion)) + 1e-6) << i;
    }
}

TEST(TimeUnion, IsTheSameInAnyOrder) {
    std::mt19937 random(5);
    for (int round = 0; round < 20000; ++round) {
        std::vector<std::pair<float, float>> intervals;
        const int range = round % 2 == 0 ? 16 : 16777216;
        const auto count = 1 + random() % 8;
        for (unsigned i = 0; i < count; ++i) {
            const auto begin = static_cast<int>(random() % static_cast<unsigned>(range)),
                       end = begin + static_cast<int>(random() % static_cast<unsigned>(range - begin + 1));
            intervals.emplace_back(static_cast<float>(begin), static_cast<float>(end));
        }
        std::vector<ShadowedTimes::Interval> truth;
        for (const auto& [begin, end] : intervals)
            truth.emplace_back(static_cast<double>(begin), static_cast<double>(end));
        for (int order = 0; order < 3; ++order) {
            std::shuffle(intervals.begin(), intervals.end(), random);
            TimeUnion u = shared::emptyTimeUnion();
            for (const auto& [begin, end] : intervals) u = shared::withInterval(u, begin, end);
            ASSERT_EQ(u.full, 0u);
            ASSERT_EQ(static_cast<double>(u.covered), ShadowedTimes::measure(truth));
        }
    }
}

TEST(TimeUnion, SaysWhenItIsFull) {
    TimeUnion u = shared::emptyTimeUnion();
    for (int i = 0; i < 8; ++i)
        u = shared::withInterval(u, 10.0f * static_cast<float>(i), 10.0f * static_cast<float>(i) + 5.0f);
    EXPECT_EQ(u.full, 0u);
    EXPECT_EQ(u.covered, 40.0f);
    EXPECT_EQ(shared::withInterval(u, 5.0f, 7.0f).full, 0u) << "it touches another";
    EXPECT_EQ(shared::withInterval(u, 6.0f, 7.0f).full, 1u);
    u = shared::withInterval(u, 0.0f, 75.0f);
    EXPECT_EQ(u.covered, 75.0f);
    u = shared::withInterval(u, 100.0f, 101.0f);
    EXPECT_EQ(u.full, 0u);
    EXPECT_EQ(u.covered, 76.0f);
}

}  // namespace
}  // namespace timeshade
