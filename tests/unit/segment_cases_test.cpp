// Segments that are known: edges that pass, touch and turn, planes that pass through one another, edge-on, in one
// plane, at the near distance; and what must stay the same when a scene is reversed in time or seen from a moving
// frame.
#include <algorithm>
#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "oracle/seen_segments.h"
#include "oracle/segment_oracle.h"

namespace timeshade {
namespace {

using glm::dvec3;
using glm::vec2;
using Segments = std::vector<SeenSegment>;

constexpr double height = 4.0, nearDistance = 0.5;
constexpr std::uint32_t floorQuad = 0;

/// A floor at z = 0, quad 0, seen from above; the image's side shows [-2, 2] of it.
class SeenFromAbove {
  public:
    SeenFromAbove() {
        scene.quads.push_back(slidingQuad({0.0, 0.0, 0.0}, {0.0, 0.0, 0.0}, 9.0, -9.0, 9.0));
        camera({0.0, 0.0, height}, {0.0, 0.0, height});
        scene.lightOpen.position = scene.lightClose.position = {0.0, 0.0, 10.0};
    }
    void camera(const dvec3& open, const dvec3& close) {
        const double angle = 2.0 * std::atan(2.0 / height);
        scene.cameraOpen = lookAt(open, open - dvec3(0, 0, 1), {0.0, 1.0, 0.0}, angle, nearDistance);
        scene.cameraClose = lookAt(close, close - dvec3(0, 0, 1), {0.0, 1.0, 0.0}, angle, nearDistance);
    }
    void triangle(const dvec3 (&open)[3], const dvec3 (&close)[3]) {
        scene.triangles.push_back({{open[0], open[1], open[2]}, {close[0], close[1], close[2]}});
    }
    void finish() {
        scene.finish();
        planner_ = std::make_unique<FramePlanner>(scene);
        plan = planner_->plan(ProceduralScene::request(256, 256, 1, 64, 1));
        oracle = std::make_unique<SegmentOracle>(plan);
    }
    /// Where the ray that goes through (x, y) of the plane z at u = 0 passes the image.
    vec2 placeOf(double x, double y, double z = 0.0) const {
        const double scale = 64.0 * height / (height - z);
        return {static_cast<float>(128.0 + scale * x), static_cast<float>(128.0 + scale * y)};
    }
    /// The exact point of the plane z that the still camera sees there.
    dvec3 pointAt(vec2 place, double z = 0.0) const {
        const oracle::PositionRay ray = oracle::positionRay(plan, place, glm::dvec2(0.0));
        return ray.eye[0] + plan.origin + ray.direction[0] * (height - z);
    }
    Segments at(vec2 place) const { return oracle->seenBy(plan, place); }
    /// By the quads' numbers: both halves of one are one.
    Segments quadsAt(vec2 place) const {
        Segments quads;
        for (SeenSegment seen : at(place)) {
            seen.triangle = quadOf(seen.triangle);
            if (!quads.empty() && quads.back().triangle == seen.triangle)
                quads.back().u1 = seen.u1;
            else
                quads.push_back(seen);
        }
        return quads;
    }
    static std::uint32_t quadOf(std::uint32_t id) { return id == NO_TRIANGLE ? id : id / 2; }

    ProceduralScene scene;
    FramePlan plan;
    std::unique_ptr<SegmentOracle> oracle;

  private:
    std::unique_ptr<FramePlanner> planner_;
};

/// Vertices are floats relative to the plan's origin.
constexpr double ofFloats = 3e-7;

TEST(SegmentCases, AnEdgePasses) {
    SeenFromAbove s;
    s.scene.quads.push_back(slidingQuad({-1.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, 0.25, -3.0, 3.0));
    s.finish();
    for (const double x : {-0.6, -0.1, 0.0, 0.3, 0.5}) {
        const vec2 place = s.placeOf(x, 0.3, 1.0);
        const double exact = s.pointAt(place, 1.0).x;
        const Segments seen = s.quadsAt(place);
        ASSERT_EQ(seen.size(), 3u);
        EXPECT_EQ(seen[0].triangle, floorQuad);
        EXPECT_EQ(seen[2].triangle, floorQuad);
        EXPECT_NEAR(seen[0].u1, (exact - 0.25 + 1.0) / 2.0, ofFloats);
        EXPECT_NEAR(seen[2].u0, (exact + 0.25 + 1.0) / 2.0, ofFloats);
    }
}

/// What stands still is one segment, whatever it is and wherever one looks, on edges and corners too.
TEST(SegmentCases, AStillSceneGivesOneSegment) {
    SeenFromAbove s;
    for (int i = 0; i < 6; ++i) {
        const dvec3 centre(0.25 * i - 0.75, 0.0, 0.125 * (i % 3));
        s.scene.quads.push_back(slidingQuad(centre, centre, 0.25, -1.0, 0.5 * (i % 2)));
    }
    s.finish();
    for (int i = 0; i <= 64; ++i)
        for (int k = 0; k <= 64; ++k)
            ASSERT_EQ(s.at({static_cast<float>(4 * i), static_cast<float>(4 * k)}).size(), 1u) << i << ", " << k;
}

/// A deforming sheet of neighbours covers all of the image: through no edge and no corner does one look past it.
TEST(SegmentCases, NeighboursLeaveNoGap) {
    SeenFromAbove s;
    s.scene.quads.clear();
    std::mt19937 random(3);
    std::uniform_real_distribution<double> any(-0.1, 0.1);
    constexpr int side = 16;
    dvec3 corners[2][side + 1][side + 1];
    for (auto& end : corners)
        for (int i = 0; i <= side; ++i)
            for (int k = 0; k <= side; ++k) {
                const double z = any(random), x = any(random), y = any(random);
                end[i][k] = {(i - side / 2) * 0.375 + x, (k - side / 2) * 0.375 + y, z};
            }
    for (int i = 0; i < side; ++i)
        for (int k = 0; k < side; ++k) {
            MovingQuad quad{};
            const int di[4] = {0, 1, 1, 0}, dk[4] = {0, 0, 1, 1};
            for (int c = 0; c < 4; ++c) {
                quad.open[c] = corners[0][i + di[c]][k + dk[c]];
                quad.close[c] = corners[1][i + di[c]][k + dk[c]];
            }
            s.scene.quads.push_back(quad);
        }
    s.camera({0.0, 0.0, height}, {0.1, -0.05, height});
    s.finish();
    std::uniform_real_distribution<float> place(1.0f, 255.0f);
    long segments = 0;
    for (int i = 0; i < 6000; ++i) {
        const float x = place(random), y = place(random);
        vec2 at(x, y);
        // Places where the sheet's corners are at the opening: edges and corners meet there.
        if (i % 3 == 0) {
            const dvec3 corner = corners[0][4 + i % 9][4 + i / 9 % 9];
            at = s.placeOf(corner.x, corner.y, corner.z);
        }
        for (const SeenSegment& seen : s.at(at)) {
            ASSERT_NE(seen.triangle, NO_TRIANGLE) << at.x << ", " << at.y << " [" << seen.u0 << ", " << seen.u1 << "]";
            ++segments;
        }
    }
    EXPECT_GT(segments, 12000);
}

/// Two planes pass through each other inside the shutter: they change their order once, though both are met throughout.
TEST(SegmentCases, PlanesPassThroughEachOther) {
    SeenFromAbove s;
    const auto slanted = [](double low, double high) {
        MovingQuad quad{};
        const double x[4] = {-3, 3, 3, -3}, y[4] = {-3, -3, 3, 3};
        for (int c = 0; c < 4; ++c) {
            quad.open[c] = {x[c], y[c], low + 0.125 * x[c]};
            quad.close[c] = {x[c], y[c], high + 0.125 * x[c]};
        }
        return quad;
    };
    s.scene.quads.push_back(slanted(0.5, 1.5));
    s.scene.quads.push_back(slanted(1.25, 0.75));
    s.finish();
    for (const double x : {-0.7, 0.1, 0.9}) {
        const Segments seen = s.quadsAt(s.placeOf(x, 0.2));
        ASSERT_EQ(seen.size(), 2u);
        EXPECT_EQ(seen[0].triangle, 2u);
        EXPECT_EQ(seen[1].triangle, 1u);
        // 0.5 + u = 1.25 - u / 2, whatever the slant.
        EXPECT_NEAR(seen[0].u1, 0.5, 1e-12);
    }
}

/// One dips into the other and comes out again: two changes of order between ends that say nothing of it; and it may
/// only touch.
TEST(SegmentCases, PlanesDipIntoEachOther) {
    // One slants from left to right, then from right to left, and slides: its height at x = 0 is 1 - 0.3 (2 u - 1)^2.
    for (const double level : {0.9, 0.9999, 1.0001}) {
        SeenFromAbove s;
        MovingQuad turning{};
        const double x[4] = {-3, 3, 3, -3}, y[4] = {-3, -3, 3, 3};
        for (int c = 0; c < 4; ++c) {
            turning.open[c] = {x[c] - 1.0, y[c], 1.0 - 0.3 * x[c]};
            turning.close[c] = {x[c] + 1.0, y[c], 1.0 + 0.3 * x[c]};
        }
        s.scene.quads.push_back(turning);
        s.scene.quads.push_back(slidingQuad({0, 0, level}, {0, 0, level}, 3.0, -3.0, 3.0));
        s.finish();
        const vec2 place = s.placeOf(0.0, 0.2, 1.0);
        const Segments seen = s.quadsAt(place);
        // Where the turning one is as high as the other, by halving along the ray.
        std::vector<double> changes;
        const auto above = [&](double u) {
            dvec3 v[3];
            for (int c = 0; c < 3; ++c) v[c] = glm::mix(turning.open[c], turning.close[c], u);
            const dvec3 n = glm::cross(v[1] - v[0], v[2] - v[0]), p = s.pointAt(place, level);
            return glm::dot(n, v[0] - p) * n.z > 0.0;
        };
        for (int i = 0; i < 1000; ++i) {
            double low = i / 1000.0, high = (i + 1) / 1000.0;
            if (above(low) == above(high)) continue;
            for (int k = 0; k < 50; ++k) (above(0.5 * (low + high)) == above(low) ? low : high) = 0.5 * (low + high);
            changes.push_back(low);
        }
        std::vector<double> found;
        for (std::size_t i = 0; i + 1 < seen.size(); ++i)
            if (seen[i].triangle != seen[i + 1].triangle) found.push_back(seen[i].u1);
        ASSERT_EQ(found.size(), changes.size()) << level;
        EXPECT_EQ(found.size(), level < 1.0 ? 2u : 0u);
        for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], changes[i], 1e-5);
    }
}

/// A line whose ends move along the axes wraps a parabola: it touches (1/4, 1/4) at u = 1/2, where its edge function is
/// (u - 1/2)^2. A little farther out the triangle is seen for a little while; farther in, all the time.
TEST(SegmentCases, AnEdgeTouches) {
    for (const double out : {0.0, 1e-4, -1e-4, 3e-3, -3e-3}) {
        SeenFromAbove s;
        // Behind the floor there is nothing: the triangle lies above it. Seen: between the line and the corner.
        const double z = 1.0;
        s.triangle({{1.0, 0.0, z}, {0.0, 0.0, z}, {-1.0, -1.0, z}}, {{0.0, 0.0, z}, {0.0, 1.0, z}, {-1.0, -1.0, z}});
        s.finish();
        const vec2 place = s.placeOf(0.25 + out, 0.25 + out, z);
        const dvec3 p = s.pointAt(place, z);
        const Segments seen = s.at(place);
        // x u + y (1 - u) - u (1 - u) <= 0: inside.
        const double b = p.x - p.y - 1.0, c = p.y, discriminant = b * b - 4.0 * c;
        if (std::abs(discriminant) < 1e-6) {
            EXPECT_LE(seen.size(), 3u);
            continue;
        }
        ASSERT_EQ(seen.size(), discriminant > 0.0 ? 3u : 1u) << out;
        if (discriminant < 0.0) continue;
        EXPECT_EQ(seen[1].triangle, 2u);
        EXPECT_NEAR(seen[1].u0, 0.5 * (-b - std::sqrt(discriminant)), 1e-5);
        EXPECT_NEAR(seen[1].u1, 0.5 * (-b + std::sqrt(discriminant)), 1e-5);
    }
}

/// A quad whose plane holds the eye is never seen; one that turns through that is seen from its front alone.
TEST(SegmentCases, EdgeOn) {
    SeenFromAbove s;
    const double x[4] = {0, 0, 0, 0}, y[4] = {-2, 2, 2, -2}, z[4] = {0.5, 0.5, 1.5, 1.5};
    MovingQuad still{}, turning{};
    for (int c = 0; c < 4; ++c) {
        still.open[c] = still.close[c] = {x[c], y[c], z[c]};
        turning.open[c] = {c < 2 ? -1.5 : 1.5, y[c], 1.0};
        turning.close[c] = {c < 2 ? 1.5 : -1.5, y[c], 1.0};
    }
    s.scene.quads.push_back(still);
    s.scene.quads.push_back(turning);
    s.finish();
    const Segments onTheQuad = s.quadsAt({128.0f, 100.0f});
    for (const SeenSegment& seen : onTheQuad) EXPECT_NE(seen.triangle, 1u);
    const vec2 place = s.placeOf(0.6, 0.2, 1.0);
    const Segments seen = s.quadsAt(place);
    const double exact = s.pointAt(place, 1.0).x;
    // Its edges at -+(1.5 - 3 u): half of it by then; its front is up in one of the halves.
    ASSERT_EQ(seen.size(), 2u);
    const double first = (1.5 - exact) / 3.0;
    const bool frontFirst = seen[0].triangle == 2u;
    EXPECT_NEAR(seen[0].u1, frontFirst ? first : 1.0 - first, ofFloats);
}

/// Rises past the near distance: no longer seen, and what is behind it is.
TEST(SegmentCases, TheNearDistance) {
    SeenFromAbove s;
    s.scene.quads.push_back(slidingQuad({0, 0, 3.0}, {0, 0, 5.0}, 3.0, -3.0, 3.0));
    s.finish();
    for (const vec2 place : {vec2(128.0f, 128.0f), vec2(13.3f, 240.7f)}) {
        const Segments seen = s.quadsAt(place);
        ASSERT_EQ(seen.size(), 2u);
        EXPECT_EQ(seen[0].triangle, 1u);
        EXPECT_EQ(seen[1].triangle, floorQuad);
        EXPECT_NEAR(seen[0].u1, (height - nearDistance - 3.0) / 2.0, ofFloats);
    }
}

/// Of two in one plane the one with the lower number is seen, as long as both are there.
TEST(SegmentCases, InOnePlane) {
    SeenFromAbove s;
    s.scene.quads.push_back(slidingQuad({-1.0, 0.0, 1.0}, {1.0, 0.0, 1.0}, 0.5, -3.0, 3.0));
    s.scene.quads.push_back(slidingQuad({1.0, 0.0, 1.0}, {-1.0, 0.0, 1.0}, 0.75, -3.0, 3.0));
    s.finish();
    const vec2 place = s.placeOf(0.0, 0.3, 1.0);
    const Segments seen = s.quadsAt(place);
    // The lower one from 1/4 to 3/4, the other from 1/8 to 7/8.
    ASSERT_EQ(seen.size(), 5u);
    const std::uint32_t quads[5] = {0, 2, 1, 2, 0};
    const double ends[5] = {0.125, 0.25, 0.75, 0.875, 1.0};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(seen[i].triangle, quads[i]);
        EXPECT_NEAR(seen[i].u1, ends[i], 1e-6);
    }
}

/// Random quads; reversed in time, or in a frame that moves with the camera.
std::vector<MovingQuad> randomQuads(std::uint32_t seed) {
    std::mt19937 random(seed);
    // Multiples of 2^-12: so that no sum is rounded to a float.
    std::uniform_int_distribution<int> any(-4096, 4096);
    const auto within = [&](double r) {
        const double x = any(random), y = any(random), z = any(random);
        return dvec3(x, y, z) * (r / 4096.0);
    };
    std::vector<MovingQuad> quads;
    for (int i = 0; i < 24; ++i) {
        const dvec3 centre = within(2.0) * dvec3(1, 1, 0.5) + dvec3(0, 0, 1), move = within(1.0);
        MovingQuad quad{};
        const double x[4] = {-1, 1, 1, -1}, y[4] = {-1, -1, 1, 1};
        for (int c = 0; c < 4; ++c) {
            quad.open[c] = centre + 0.5 * dvec3(x[c], y[c], 0.0) + within(0.25);
            quad.close[c] = quad.open[c] + move + within(0.25);
        }
        quads.push_back(quad);
    }
    return quads;
}

TEST(SegmentCases, ReversedInTime) {
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SeenFromAbove forward, backward;
        for (const MovingQuad& quad : randomQuads(seed)) {
            forward.scene.quads.push_back(quad);
            MovingQuad reversed = quad;
            std::swap(reversed.open, reversed.close);
            backward.scene.quads.push_back(reversed);
        }
        forward.camera({0, 0, height}, {0.25, 0.5, height + 0.5});
        backward.camera({0.25, 0.5, height + 0.5}, {0, 0, height});
        forward.finish();
        backward.finish();
        ASSERT_EQ(forward.plan.origin, backward.plan.origin);
        for (int i = 0; i < 1500; ++i) {
            const vec2 place(static_cast<float>(i % 50) * 5.1f, static_cast<float>(i / 50) * 8.3f);
            const Segments a = forward.at(place), b = backward.at(place);
            ASSERT_EQ(a.size(), b.size()) << i;
            for (std::size_t k = 0; k < a.size(); ++k) {
                ASSERT_EQ(a[k].triangle, b[a.size() - 1 - k].triangle);
                ASSERT_NEAR(a[k].u0, 1.0 - b[a.size() - 1 - k].u1, 1e-11);
            }
        }
    }
}

TEST(SegmentCases, FromAMovingFrame) {
    const dvec3 way(0.5, -0.25, 0.125);
    for (std::uint32_t seed = 1; seed <= 4; ++seed) {
        SeenFromAbove still, moving;
        still.scene.quads.clear();
        moving.scene.quads.clear();
        for (const MovingQuad& quad : randomQuads(seed)) {
            still.scene.quads.push_back(quad);
            MovingQuad moved = quad;
            for (dvec3& corner : moved.close) corner += way;
            moving.scene.quads.push_back(moved);
        }
        moving.camera({0, 0, height}, dvec3(0, 0, height) + way);
        still.finish();
        moving.finish();
        for (int i = 0; i < 1500; ++i) {
            const vec2 place(static_cast<float>(i % 50) * 5.1f, static_cast<float>(i / 50) * 8.3f);
            const Segments a = still.at(place), b = moving.at(place);
            ASSERT_EQ(a.size(), b.size()) << i;
            for (std::size_t k = 0; k < a.size(); ++k) {
                ASSERT_EQ(a[k].triangle, b[k].triangle);
                ASSERT_NEAR(a[k].u0, b[k].u0, 1e-6);
            }
        }
    }
}

}  // namespace
}  // namespace timeshade
