// The shared test of a segment against a triangle, in floats, against exact arithmetic.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "oracle/segment_triangle.h"
#include "shared/segment_triangle.shared.h"
#include "support/awkward_numbers.h"

namespace timeshade {
namespace {
/// Of every receiver here, in world units: more than the rounding of coordinates of ten.
constexpr float clearance = 1e-5f;

using glm::dvec3;
using glm::vec3;

struct Bounded {
    double value = 0.0, error = 0.0;
};

/// det[d, a, b] in double, and what the header allows the float version of twice it, halved.
Bounded edge(const dvec3& d, const dvec3& a, const dvec3& b) {
    const dvec3 s = glm::abs(a + b), e = glm::abs(b - a), l = glm::abs(d);
    const double sizes = l.x * (s.y * e.z + s.z * e.y) + l.y * (s.z * e.x + s.x * e.z) + l.z * (s.x * e.y + s.y * e.x);
    return {glm::dot(d, glm::cross(a, b)), 0.5 * std::ldexp(9.0 * sizes, -24) + 1e-30};
}

/// Whether the header's error bound allows either result.
bool undecided(const SegmentAndTriangle& s) {
    const dvec3 l(s.toLight), v0(s.v[0]), v1(s.v[1]), v2(s.v[2]);
    for (const Bounded& e : {edge(l, v1, v2), edge(l, v2, v0), edge(l, v0, v1)})
        if (std::abs(e.value) <= e.error) return true;
    const dvec3 a = v1 - v0, b = v2 - v0, n = glm::cross(a, b);
    const dvec3 x = glm::abs(a), y = glm::abs(b);
    const dvec3 sizes(x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x);
    const double plane = glm::dot(n, v0), through = glm::dot(n, l);
    const double error = std::ldexp(glm::dot(sizes, glm::abs(v0)) + glm::dot(sizes, glm::abs(l)), -20) + 1e-30;
    return std::abs(through) <= error || std::abs(std::abs(plane) - std::abs(through)) <= error ||
           std::abs(std::abs(plane) - static_cast<double>(clearance) * glm::length(n)) <= error;
}

bool exactly(const SegmentAndTriangle& s) {
    const oracle::Segment segment{dvec3(0.0), dvec3(s.toLight), 0.0, 1.0, HUGE_VAL, static_cast<double>(clearance)};
    const dvec3 vertices[3] = {dvec3(s.v[0]), dvec3(s.v[1]), dvec3(s.v[2])};
    return oracle::meet(segment, vertices).hit;
}

bool inFloats(const SegmentAndTriangle& s) {
    return shared::segmentMeetsTriangle(s.toLight, s.v[0], s.v[1], s.v[2], clearance);
}

TEST(SharedSegmentTriangle, DecidesAsExactArithmetic) {
    constexpr int count = 1000000;
    AwkwardNumbers numbers(1);
    int hits = 0, open = 0;
    for (int i = 0; i < count; ++i) {
        const SegmentAndTriangle s = awkwardSegmentAndTriangle(numbers);
        const bool hit = inFloats(s);
        hits += hit ? 1 : 0;
        if (hit == exactly(s)) continue;
        ++open;
        ASSERT_TRUE(undecided(s)) << "input " << i << " is clear, and decided wrongly";
    }
    EXPECT_GT(hits, count / 10);
    EXPECT_LT(open, count / 20);
}

TEST(SharedSegmentTriangle, NeighboursLeaveNoGap) {
    // Two triangles that meet in an edge, with the segment through a point of it, on both sides of the plane.
    constexpr int count = 500000;
    AwkwardNumbers numbers(2);
    for (int i = 0; i < count; ++i) {
        const vec3 l(numbers.between(-3.0f, 3.0f), numbers.between(-3.0f, 3.0f), 10.0f);
        const vec3 crossing = l * 0.5f;
        const vec3 across(numbers.between(-2.0f, 2.0f), numbers.between(-2.0f, 2.0f), numbers.between(-1.0f, 1.0f));
        const vec3 along(-across.y + 0.1f, across.x + 0.1f, numbers.between(-0.5f, 0.5f));
        const float t = numbers.between(0.2f, 0.8f);
        const vec3 a = crossing - across * t, b = crossing + across * (1.0f - t);
        if (std::abs(across.x) + std::abs(across.y) < 0.01f) continue;
        const vec3 c = crossing + along, d = crossing - along;
        ASSERT_TRUE(shared::segmentMeetsTriangle(l, a, b, c, 0.0f) || shared::segmentMeetsTriangle(l, b, a, d, 0.0f))
            << "input " << i;
    }
}

TEST(SharedSegmentTriangle, OrderAndMirroringOfVerticesChangeNothing) {
    AwkwardNumbers numbers(3);
    for (int i = 0; i < 300000; ++i) {
        const SegmentAndTriangle s = awkwardSegmentAndTriangle(numbers);
        if (undecided(s)) continue;
        const bool hit = inFloats(s);
        ASSERT_EQ(hit, inFloats({s.toLight, {s.v[1], s.v[2], s.v[0]}})) << i;
        ASSERT_EQ(hit, inFloats({s.toLight, {s.v[1], s.v[0], s.v[2]}})) << i;
        ASSERT_EQ(hit, inFloats({-s.toLight, {-s.v[0], -s.v[1], -s.v[2]}})) << i;
    }
}

/// Case 27: receivers near a square's diagonal, of one triangle, tested against
/// the other, with coordinates of ten. A light that grazes needs the plane rule.
TEST(SharedSegmentTriangle, CoplanarNeighboursDoNotShadow) {
    AwkwardNumbers numbers(4);
    int shadowed = 0, withoutRule = 0;
    for (int i = 0; i < 400000; ++i) {
        const float along = numbers.unit(), side = numbers.between(-1e-6f, 1e-6f);
        const float x = 10.0f + along + side, y = 10.0f + along - side, tilt = 0.1f * numbers.unit();
        const auto onPlane = [&](float px, float py) { return vec3(px, py, 10.0f + tilt * (px - 10.0f)); };
        const vec3 p = onPlane(x, y), light = p + (i % 2 == 0 ? vec3(0.0f, 0.0f, 10.0f) : vec3(-2.0f, 10.0f, 0.005f));
        const vec3 v0 = onPlane(10.0f, 10.0f) - p, v1 = onPlane(11.0f, 11.0f) - p, v2 = onPlane(10.0f, 11.0f) - p;
        shadowed += shared::segmentMeetsTriangle(light - p, v0, v1, v2, std::ldexp(11.0f, -21)) ? 1 : 0;
        withoutRule += shared::segmentMeetsTriangle(light - p, v0, v1, v2, 0.0f) ? 1 : 0;
    }
    EXPECT_EQ(shadowed, 0);
    EXPECT_GT(withoutRule, 100) << "the light does not graze: the test above shows nothing";
}

TEST(SharedSegmentTriangle, ContactsCastShadowsDownToTheClearance) {
    for (const float gap : {1e-1f, 1e-3f, 1e-5f, 1.1e-6f, 0.9e-6f, 1e-7f, -1e-6f})
        for (const float distance : {1.0f, 10.0f, 1e5f}) {  // to the light, which does not matter
            const vec3 l(0.3f * distance, 0.0f, distance);
            EXPECT_EQ(
                shared::segmentMeetsTriangle(l, {-1.0f, -1.0f, gap}, {1.0f, -1.0f, gap}, {0.1f, 1.0f, gap}, 1e-6f),
                gap > 1e-6f)
                << gap << ", light at " << distance;
        }
}

/// What a receiver's position may be wrong by in floats is less than its clearance: weighted sums of the vertices of
/// triangles of all shapes, against the same in double precision.
TEST(ReceiverClearance, BoundsTheRoundingOfReceivers) {
    AwkwardNumbers numbers(6);
    double worst = 0.0;
    for (int i = 0; i < 300000; ++i) {
        const vec3 open[3] = {numbers.point(), numbers.point(), numbers.point()};
        const vec3 close[3] = {numbers.point(), numbers.point(), numbers.point()};
        const float u = numbers.unit(), b = numbers.unit(), c = (1.0f - b) * numbers.unit();
        const vec3 weights = vec3(1.0f - b - c, b, c) * numbers.between(0.5f, 2.0f);
        const vec3 w = weights / (weights.x + weights.y + weights.z);  // as receiverOf makes them
        vec3 v[3], p(0.0f);
        dvec3 exact(0.0);
        const dvec3 exactWeights = dvec3(weights) / (dvec3(weights).x + dvec3(weights).y + dvec3(weights).z);
        for (int k = 0; k < 3; ++k) {
            v[k] = glm::mix(open[k], close[k], u);
            exact += exactWeights[k] * (dvec3(open[k]) * (1.0 - double(u)) + dvec3(close[k]) * double(u));
        }
        p = w.x * v[0] + w.y * v[1] + w.z * v[2];
        // Of vertices that cancel while they move, the rounding is that of their ends.
        float ends = 0.0f;
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis)
                ends = std::max({ends, std::abs(open[k][axis]), std::abs(close[k][axis])});
        const float bound = std::max(shared::receiverClearance(v[0], v[1], v[2]), std::ldexp(ends, -22));
        const dvec3 off = glm::abs(dvec3(p) - exact);
        worst = std::max(worst, std::max({off.x, off.y, off.z}) / static_cast<double>(bound));
    }
    EXPECT_LT(worst, 1.0);
    EXPECT_GT(worst, 0.1) << "the bound is far from what happens";
}

/// A segment that is equally far inside of all three edges: equal sides are no sign of a triangle without area.
TEST(SharedSegmentTriangle, ThroughTheCentre) {
    EXPECT_TRUE(shared::segmentMeetsTriangle({64, 64, 64}, {63, 63, 64}, {63, 64, 63}, {64, 63, 63}, 0.0f));
}

TEST(SharedSegmentTriangle, NothingFromNothing) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const float bad : {nan, infinity, -infinity}) {
        for (int place = 0; place < 12; ++place) {
            vec3 v[4] = {{0.0f, 0.0f, 10.0f}, {-1.0f, -1.0f, 5.0f}, {1.0f, -1.0f, 5.0f}, {0.0f, 1.0f, 5.0f}};
            v[place / 3][place % 3] = bad;
            EXPECT_FALSE(shared::segmentMeetsTriangle(v[0], v[1], v[2], v[3], 0.0f)) << bad << " at " << place;
        }
    }
    EXPECT_FALSE(shared::segmentMeetsTriangle({0, 0, 10}, {0, 0, 5}, {0, 0, 5}, {0, 0, 5}, 0.0f)) << "a point";
    EXPECT_FALSE(shared::segmentMeetsTriangle({0, 0, 10}, {-1, 0, 4}, {0, 0, 6}, {1, 0, 4}, 0.0f)) << "edge-on";
    EXPECT_FALSE(shared::segmentMeetsTriangle({0, 0, 0}, {-1, -1, 5}, {1, -1, 5}, {0, 1, 5}, 0.0f)) << "no segment";
}

TEST(VertexFromReceiver, StaticVerticesDoNotMove) {
    AwkwardNumbers numbers(5);
    for (int i = 0; i < 100000; ++i) {
        const vec3 v = numbers.point(), p = numbers.point();
        ASSERT_EQ(shared::vertexFromReceiver(v, v, numbers.unit(), p), v - p);
    }
}

}  // namespace
}  // namespace timeshade
