// The bounds of a moving triangle: whatever of it can be seen, at any time, lies inside. Random and adversarial
// triangles from a fixed seed, against double precision, point by point.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "plan/view_plan.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {
namespace {

using glm::dvec2;
using glm::dvec3;
using glm::vec3;
using shared::SweptBounds;

/// View coordinates of a triangle at both ends of an interval.
struct Moving {
    std::array<vec3, 3> a, b;

    /// A point of the triangle at time u.
    dvec3 at(const dvec3& barycentrics, double u) const {
        dvec3 point(0.0);
        for (int i = 0; i < 3; ++i)
            point += barycentrics[i] *
                     ((1.0 - u) * dvec3(a[static_cast<std::size_t>(i)]) + u * dvec3(b[static_cast<std::size_t>(i)]));
        return point;
    }
    double largest() const {
        float size = 0.0f;
        for (const auto* end : {&a, &b})
            for (const vec3& v : *end) size = std::max({size, std::abs(v.x), std::abs(v.y), std::abs(v.z)});
        return static_cast<double>(size);
    }
};

class SweptBoundsTest : public testing::Test {
  protected:
    double number(double low, double high) { return std::uniform_real_distribution(low, high)(random_); }
    bool oneIn(int n) { return std::uniform_int_distribution(1, n)(random_) == 1; }

    /// Mostly about an image of unit size at distance 1, now and then degenerate, behind the eye or on its plane.
    vec3 vertex(double nearest, double farthest) {
        double z = number(nearest, farthest);
        if (oneIn(20)) z = 0.0;
        if (oneIn(40)) z = number(-1e-7, 1e-7);
        const double spread = oneIn(10) ? 30.0 : 1.5;
        dvec3 v(number(-spread, spread), number(-spread, spread), z);
        if (oneIn(30)) v.x = 0.0;
        if (oneIn(30)) v.y = v.z;  // on the image's border
        return vec3(v);
    }

    Moving triangle(double nearest, double farthest) {
        Moving t;
        const vec3 move(vertex(-0.5, 0.5) * 0.3f);
        for (std::size_t i = 0; i < 3; ++i) {
            t.a[i] = vertex(nearest, farthest);
            t.b[i] = oneIn(2) ? t.a[i] + move : vertex(nearest, farthest);
        }
        if (oneIn(20)) t.a[1] = t.a[0];
        if (oneIn(20)) t.b = t.a;
        return t;
    }

    /// Corners, edges and the inside, all of them often.
    dvec3 barycentrics() {
        dvec3 w(number(0.0, 1.0), number(0.0, 1.0), number(0.0, 1.0));
        for (int i = 0; i < 3; ++i)
            if (oneIn(3)) w[i] = 0.0;
        const double sum = w.x + w.y + w.z;
        return sum > 0.0 ? w / sum : dvec3(1.0, 0.0, 0.0);
    }

    double time() { return oneIn(4) ? 0.0 : oneIn(4) ? 1.0 : number(0.0, 1.0); }

    std::mt19937 random_{20070815};
};

bool inImage(const dvec2& position) {
    return position.x >= 0.0 && position.y >= 0.0 && position.x <= 1.0 && position.y <= 1.0;
}

/// How far outside of the bounds a position lies; 0 inside.
double outside(const SweptBounds& bounds, const dvec2& position) {
    const dvec2 below = dvec2(bounds.low) - position, above = position - dvec2(bounds.high);
    return std::max({below.x, below.y, above.x, above.y, 0.0});
}

SweptBounds perspective(const Moving& t, float nearDistance) {
    return shared::sweptBoundsPerspective(t.a[0], t.a[1], t.a[2], t.b[0], t.b[1], t.b[2], nearDistance);
}

TEST_F(SweptBoundsTest, PerspectiveHoldsEverythingThatIsSeen) {
    constexpr double nearDistance = 0.02;
    std::size_t seen = 0, crossing = 0, open = 0;
    for (int i = 0; i < 60000; ++i) {
        const Moving t = triangle(oneIn(2) ? -2.0 : 0.0, 4.0);
        const SweptBounds bounds = perspective(t, static_cast<float>(nearDistance));
        crossing += bounds.crosses;
        open += bounds.low == glm::vec2(0) || bounds.high == glm::vec2(1) ? 1u : 0u;
        // Each quotient is rounded once, to 2^-24 of itself. Two points, one in front and one behind, that are off by
        // this much against each other move what lies between them by up to their size over the near distance.
        const double tolerance = std::ldexp(1.0, -22) * (1.0 + t.largest() / nearDistance);
        for (int j = 0; j < 32; ++j) {
            const dvec3 point = t.at(barycentrics(), time());
            if (!(point.z > nearDistance)) continue;
            const dvec2 position(point.x / point.z, point.y / point.z);
            if (!inImage(position)) continue;
            ++seen;
            ASSERT_LE(outside(bounds, position), tolerance)
                << "triangle " << i << ": (" << position.x << ", " << position.y << ") is not in (" << bounds.low.x
                << ", " << bounds.low.y << ") .. (" << bounds.high.x << ", " << bounds.high.y << ")";
        }
    }
    // The cases that matter did occur.
    EXPECT_GT(seen, 100000u);
    EXPECT_GT(crossing, 10000u);
    EXPECT_GT(open, 1000u);
}

TEST_F(SweptBoundsTest, PerspectiveInFrontOfTheEyeIsTheHullOfTheEnds) {
    for (int i = 0; i < 20000; ++i) {
        Moving t = triangle(0.5, 4.0);
        for (auto* end : {&t.a, &t.b})
            for (vec3& v : *end) v.z = std::max(v.z, 0.5f);
        dvec2 low(1e9), high(-1e9);
        for (const auto* end : {&t.a, &t.b}) {
            for (const vec3& v : *end) {
                low = glm::min(low, dvec2(dvec3(v)) / static_cast<double>(v.z));
                high = glm::max(high, dvec2(dvec3(v)) / static_cast<double>(v.z));
            }
        }
        const SweptBounds bounds = perspective(t, 0.02f);
        ASSERT_EQ(bounds.crosses, 0u);
        for (int d = 0; d < 2; ++d) {
            // One rounded division.
            ASSERT_NEAR(static_cast<double>(bounds.low[d]), low[d], std::ldexp(std::abs(low[d]), -23));
            ASSERT_NEAR(static_cast<double>(bounds.high[d]), high[d], std::ldexp(std::abs(high[d]), -23));
        }
    }
}

TEST_F(SweptBoundsTest, WhatIsNearerThanAnythingSeenHasNoBounds) {
    for (int i = 0; i < 1000; ++i) {
        Moving t = triangle(-2.0, 0.01);
        for (auto* end : {&t.a, &t.b})
            for (vec3& v : *end) v.z = std::min(v.z, 0.02f);
        const SweptBounds bounds = perspective(t, 0.02f);
        ASSERT_GT(bounds.low.x, bounds.high.x);
        ASSERT_GT(bounds.low.y, bounds.high.y);
    }
}

TEST_F(SweptBoundsTest, BehindTheEyeIsFlagged) {
    Moving t{{vec3(0.5f, 0.5f, 1.0f), vec3(0.6f, 0.5f, 1.0f), vec3(0.5f, 0.6f, 1.0f)}, {}};
    t.b = t.a;
    EXPECT_EQ(perspective(t, 0.02f).crosses, 0u);
    t.b[2].z = -0.1f;
    EXPECT_EQ(perspective(t, 0.02f).crosses, 1u);
}

TEST_F(SweptBoundsTest, OrthographicIsTheHullOfTheEnds) {
    for (int i = 0; i < 20000; ++i) {
        const Moving t = triangle(-2.0, 4.0);
        const SweptBounds bounds = shared::sweptBoundsOrthographic(t.a[0], t.a[1], t.a[2], t.b[0], t.b[1], t.b[2]);
        glm::vec2 low(t.a[0]), high(t.a[0]);
        for (const auto* end : {&t.a, &t.b})
            for (const vec3& v : *end) low = glm::min(low, glm::vec2(v)), high = glm::max(high, glm::vec2(v));
        ASSERT_EQ(bounds.low, low);
        ASSERT_EQ(bounds.high, high);
        ASSERT_EQ(bounds.crosses, 0u);
        // A weighted mean in double may leave the hull by its own rounding only.
        for (int j = 0; j < 8; ++j)
            ASSERT_LE(outside(bounds, dvec2(t.at(barycentrics(), time()))), 1e-12 * (1.0 + t.largest()));
    }
}

/// A camera that turns about its eye, in the form that the plan gives it.
class TurningBounds : public SweptBoundsTest {
  protected:
    static glm::dmat3 turnBy(double yaw, double pitch) {
        const glm::dmat3 about_y(std::cos(yaw), 0, -std::sin(yaw), 0, 1, 0, std::sin(yaw), 0, std::cos(yaw));
        const glm::dmat3 about_x(1, 0, 0, 0, std::cos(pitch), std::sin(pitch), 0, -std::sin(pitch), std::cos(pitch));
        return about_y * about_x;
    }

    static ViewEnd end(const glm::dmat3& axes, double height) {
        ViewEnd view;
        view.eye = dvec3(0.0);
        view.right = axes[0] * height * 4.0 / 3.0;
        view.up = axes[1] * height;
        view.corner = -axes[2] - 0.5 * view.right - 0.5 * view.up;
        return view;
    }

    ViewPlan turning(double largestTurn) {
        ViewPlan view;
        const double height = number(0.4, 1.6), yaw = number(-3.0, 3.0), pitch = number(-1.0, 1.0);
        const double turn = number(-largestTurn, largestTurn), nod = number(-0.3, 0.3) * largestTurn;
        view.open = end(turnBy(yaw, pitch), height);
        view.close = end(turnBy(yaw + turn, pitch + nod), height * (oneIn(4) ? 1.3 : 1.0));
        finishView(view, {640.0, 480.0}, 0.02, 0.0);
        return view;
    }

    /// Where the camera of time u sees a point given in the view's coordinates: (s, t) and the distance.
    static dvec3 seen(const ViewPlan& view, const dvec3& point, double u) {
        const glm::dmat3 rays =
            (1.0 - u) * glm::dmat3(glm::dmat4(view.block.raysOpen)) + u * glm::dmat3(glm::dmat4(view.block.raysClose));
        const dvec3 h = glm::inverse(rays) * point;
        return {h.x / h.z, h.y / h.z, h.z};
    }

    static SweptBounds bounds(const Moving& t, const ViewPlan& view) {
        return shared::sweptBoundsTurning(t.a[0], t.a[1], t.a[2], t.b[0], t.b[1], t.b[2], view.block.raysOpen,
                                          view.block.raysClose);
    }
};

TEST_F(TurningBounds, HoldEverythingThatIsSeen) {
    std::size_t count = 0, crossing = 0;
    double worstInFront = 0.0;
    for (int i = 0; i < 40000; ++i) {
        const ViewPlan view = turning(oneIn(2) ? 0.2 : 1.5);
        ASSERT_TRUE(view.turns);
        const bool inFront = oneIn(2);
        const Moving t = triangle(inFront ? 1.0 : -2.0, 4.0);
        const SweptBounds b = bounds(t, view);
        crossing += b.crosses;
        for (int j = 0; j < 32; ++j) {
            const double u = time();
            const dvec3 s = seen(view, t.at(barycentrics(), u), u);
            if (!(s.z > 0.02) || !inImage(dvec2(s))) continue;
            ++count;
            // A Bezier point is a sum of some thirty products of the coordinates, each rounded; over the homogeneous
            // weight, which is as small as the distance.
            const double error = outside(b, dvec2(s));
            ASSERT_LE(error, std::ldexp(1.0, -19) * (1.0 + t.largest() / 0.02))
                << "triangle " << i << " at " << s.x << ", " << s.y;
            if (b.crosses == 0u) worstInFront = std::max(worstInFront, error);
        }
    }
    EXPECT_GT(count, 100000u);
    EXPECT_GT(crossing, 5000u);
    // Where the triangle is in front of the eye: well below the slack of 1/64 pixel that the vertex shader adds, at
    // 2048 pixels.
    EXPECT_LT(worstInFront, 1.0 / 64.0 / 2048.0);
}

TEST_F(TurningBounds, AreThoseOfAStaticCameraWhereItDoesNotTurn) {
    const glm::mat4 still(1.0f);
    for (int i = 0; i < 5000; ++i) {
        Moving t = triangle(0.5, 4.0);
        for (auto* end : {&t.a, &t.b})
            for (vec3& v : *end) v.z = std::max(v.z, 0.5f);
        const SweptBounds a = shared::sweptBoundsTurning(t.a[0], t.a[1], t.a[2], t.b[0], t.b[1], t.b[2], still, still);
        const SweptBounds b = perspective(t, 0.02f);
        for (int d = 0; d < 2; ++d) {
            // Inner Bezier points are means of the ends, rounded twice more.
            ASSERT_NEAR(static_cast<double>(a.low[d]), static_cast<double>(b.low[d]),
                        std::ldexp(1.0 + t.largest() / 0.5, -21));
            ASSERT_NEAR(static_cast<double>(a.high[d]), static_cast<double>(b.high[d]),
                        std::ldexp(1.0 + t.largest() / 0.5, -21));
        }
    }
}

}  // namespace
}  // namespace timeshade
