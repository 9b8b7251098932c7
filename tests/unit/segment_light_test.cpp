// For how long the receiver of a segment is lit: closed forms, and the oracle's own test of instants, halved to where
// it changes.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "oracle/camera_rays.h"
#include "oracle/oracle.h"
#include "oracle/resolve_shadow.h"
#include "oracle/seen_segments.h"
#include "oracle/segment_oracle.h"
#include "scene_catalogue.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {
namespace {

using glm::dvec3;
using glm::vec2;

/// With TIMESHADE_MANY set: thirty times as many.
int many(int usual) { return std::getenv("TIMESHADE_MANY") != nullptr ? 30 * usual : usual; }

/// The same, from so many instants of a segment, and halving between two that differ. What begins and ends between two
/// is missed.
class ByInstants {
  public:
    explicit ByInstants(const FramePlan& plan) : plan_(plan), triangles_(plan.texels->positions), bvh_(triangles_) {}

    LitSegment of(vec2 place, const SeenSegment& segment, int instants) const {
        const oracle::PositionRay ray = oracle::positionRay(plan_, place, glm::dvec2(0.0));
        LitSegment sum{segment};
        const double step = (segment.u1 - segment.u0) / instants;
        double begin = segment.u0;
        State before = at(ray, segment.triangle, segment.u0 + 0.5 * step);
        const auto add = [&](double end) {
            const double time = exposure(end) - exposure(begin);
            sum.tested += before == Untested ? 0.0 : time;
            sum.lit += before == Lit ? time : 0.0;
            begin = end;
        };
        for (int i = 1; i < instants; ++i) {
            double low = segment.u0 + (i - 0.5) * step, high = low + step;
            const State now = at(ray, segment.triangle, high);
            if (now == before) continue;
            for (int k = 0; k < 44; ++k) {
                const double middle = 0.5 * (low + high);
                (at(ray, segment.triangle, middle) == before ? low : high) = middle;
            }
            add(high);
            before = now;
        }
        add(segment.u1);
        return sum;
    }

  private:
    enum State { Untested, Dark, Lit };
    State at(const oracle::PositionRay& ray, std::uint32_t triangle, double u) const {
        const oracle::Receiver r = oracle::receiverOf(plan_, triangles_, oracle::rayAt(ray, u), triangle);
        if (!r.answer.tested) return Untested;
        return oracle::resolveShadow(bvh_, triangles_, r.answer.position, r.light, r.clearance, triangle, u).lit ? Lit
                                                                                                                 : Dark;
    }
    /// Of the shared functions, whose own error it has, but for a box.
    double exposure(double u) const {
        if (plan_.block.response == SHUTTER_BOX) return u;
        return static_cast<double>(
            shared::shutterExposure(plan_.block.response, plan_.block.responseWidth, static_cast<float>(u)));
    }

    const FramePlan& plan_;
    oracle::MovingTriangles triangles_;
    oracle::SweptBvh bvh_;
};

struct Tally {
    long segments = 0, partly = 0, off = 0, missed = 0;
    double mean = 0.0, worst = 0.0;
};

/// `precision`: of the exposure.
Tally compare(const FramePlan& plan, int places, std::uint32_t seed, double precision) {
    const SegmentOracle oracle(plan);
    const ByInstants instants(plan);
    std::mt19937 random(seed);
    const glm::vec2 size(plan.camera.block.size);
    std::uniform_real_distribution<float> x(0.0f, size.x), y(0.0f, size.y);
    Tally tally;
    for (int i = 0; i < places; ++i) {
        const float left = x(random), low = y(random);
        const vec2 place(left, low);
        for (const LitSegment& got : oracle.litOver(plan, place, oracle.seenBy(plan, place))) {
            if (got.seen.triangle == NO_TRIANGLE) continue;
            const auto errorOf = [&](const LitSegment& truth) {
                return std::max(std::abs(got.lit - truth.lit), std::abs(got.tested - truth.tested));
            };
            LitSegment truth = instants.of(place, got.seen, 192);
            if (errorOf(truth) > precision) truth = instants.of(place, got.seen, 20000);
            const double error = errorOf(truth);
            ++tally.segments;
            tally.partly += got.lit > 0.0 && got.lit < got.tested ? 1 : 0;
            // A shadow, or a gap, shorter than the instants' spacing; two of them at most.
            const double spacing = 4.0 * (got.seen.u1 - got.seen.u0) / 20000.0;
            tally.missed += error > precision && error < spacing ? 1 : 0;
            if (error >= std::max(spacing, precision) && tally.off++ == 0)
                ADD_FAILURE() << "at " << left << ", " << low << " triangle " << got.seen.triangle << " of ["
                              << got.seen.u0 << ", " << got.seen.u1 << "]: lit " << got.lit << " of " << got.tested
                              << ", not " << truth.lit << " of " << truth.tested;
            if (error > precision) continue;
            tally.mean += error;
            tally.worst = std::max(tally.worst, error);
        }
    }
    tally.mean /= static_cast<double>(tally.segments);
    return tally;
}

void report(const std::string& name, const Tally& t) {
    std::printf(
        "%s: %ld segments, %ld partly lit, mean error %.1e, worst %.1e, %ld with shadows too short for instants\n",
        name.c_str(), t.segments, t.partly, t.mean, t.worst, t.missed);
}

struct Kind {
    const char* name;
    bool directional, lightMoves, cameraMoves;
    double turn = 0.0;  ///< of the light's axes, radians
    std::uint32_t response = SHUTTER_BOX;
};
class SegmentLight : public testing::TestWithParam<Kind> {};

FramePlan randomPlan(const Kind& kind, std::uint32_t seed, ProceduralScene& scene) {
    std::mt19937 random(seed);
    const auto within = [&](double r) {
        std::uniform_real_distribution<double> any(-r, r);
        const double x = any(random), y = any(random), z = any(random);
        return dvec3(x, y, z);
    };
    scene.quads.push_back(slidingQuad({0.0, 0.0, 0.0}, within(0.5), 6.0, -6.0, 6.0));
    for (int i = 0; i < 30; ++i) {
        const double size = 0.1 + 0.5 * std::abs(within(1.0).x);
        const dvec3 centre = within(2.5) * dvec3(1.0, 1.0, 0.6) + dvec3(0.0, 0.0, 1.6), move = within(1.0);
        const dvec3 a = size * glm::normalize(within(1.0)), b = size * glm::normalize(within(1.0));
        MovingQuad quad{{centre - a - b, centre + a - b, centre + a + b, centre - a + b}, {}};
        for (int c = 0; c < 4; ++c) quad.close[c] = quad.open[c] + move + within(0.4 * size);
        scene.quads.push_back(quad);
    }
    scene.cameraOpen = scene.cameraClose = lookAt({1.0, -7.0, 6.0}, {0.0, 0.0, 0.5}, {0.0, 0.0, 1.0}, 0.8, 0.5);
    if (kind.cameraMoves) scene.cameraClose = lookAt({0.2, -7.3, 5.5}, {0.4, 0.1, 0.7}, {0.1, 0.0, 1.0}, 0.8, 0.5);
    scene.lightOpen.kind = kind.directional ? LightKind::Directional : LightKind::Spot;
    scene.lightOpen.position = {-1.0, -0.5, 8.0};
    scene.lightOpen.axes = lookAt(scene.lightOpen.position, {0.0, 0.3, 0.0}, {0.0, 1.0, 0.0}, 0.8, 0.1).axes;
    scene.lightOpen.outerConeAngle = 0.35;
    scene.lightClose = scene.lightOpen;
    if (kind.lightMoves) scene.lightClose.position += dvec3(2.0, 1.0, -1.0);
    scene.finish();
    FramePlan plan = FramePlanner(scene).plan(ProceduralScene::request(320, 240, 4, 64, seed));
    plan.block.response = kind.response;
    plan.block.responseWidth = 1.0f / 6.0f;
    if (kind.turn == 0.0) return plan;
    // The scene's light does not turn; the plan's does.
    const dvec3 target(8.0 * kind.turn, 0.3, 0.0);
    plan.lightClose.axes = lookAt(scene.lightOpen.position, target, {0.0, 1.0, 0.0}, 0.8, 0.1).axes;
    plan.lightAxes[2] = glm::normalize(plan.lightOpen.axes[2] + plan.lightClose.axes[2]);
    return plan;
}

TEST_P(SegmentLight, IsThatOfInstants) {
    Tally sum;
    for (std::uint32_t seed = 1; seed <= 3; ++seed) {
        ProceduralScene scene;
        const FramePlan plan = randomPlan(GetParam(), seed, scene);
        // The axis of a spot that turns is taken at floats, exposures but for a box are floats.
        const bool floats = GetParam().turn != 0.0 || GetParam().response != SHUTTER_BOX;
        const double precision = GetParam().response == SHUTTER_GAUSSIAN ? 2e-6 : floats ? 3e-7 : 1e-9;
        const Tally tally = compare(plan, many(60), seed, precision);
        sum.segments += tally.segments;
        sum.partly += tally.partly;
        sum.off += tally.off;
        sum.missed += tally.missed;
        sum.mean += tally.mean / 3.0;
        sum.worst = std::max(sum.worst, tally.worst);
    }
    report(GetParam().name, sum);
    EXPECT_EQ(sum.off, 0);
    EXPECT_GT(sum.partly, sum.segments / 12);
    EXPECT_LE(sum.missed, 1 + sum.segments / 200);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SegmentLight,
                         testing::Values(Kind{"spot", false, false, false}, Kind{"lamp", false, true, false},
                                         Kind{"all", false, true, true}, Kind{"turning", false, true, true, 0.3},
                                         Kind{"sun", true, false, false}, Kind{"turning_sun", true, false, true, 0.4},
                                         Kind{"tent", false, true, true, 0.0, SHUTTER_TENT},
                                         Kind{"gaussian", false, true, true, 0.0, SHUTTER_GAUSSIAN}),
                         [](const auto& kind) { return kind.param.name; });

class SegmentLightScenes : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(SegmentLightScenes, IsThatOfInstants) {
    const std::unique_ptr<Scene> scene = openScene(GetParam().first, "");
    FrameRequest request;
    request.width = 320;
    request.height = 240;
    request.frame = GetParam().second;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    const Tally tally = compare(plan, many(150), 5, 1e-9);
    report(GetParam().first, tally);
    EXPECT_EQ(tally.off, 0);
    EXPECT_LE(tally.missed, 1 + tally.segments / 200);
}

INSTANTIATE_TEST_SUITE_P(Scenes, SegmentLightScenes,
                         testing::Values(std::pair("chess", 20.0), std::pair("octopus", 96.0),
                                         std::pair("pillars", 11.0), std::pair("cubes", 0.0)),
                         [](const auto& scene) { return std::string(scene.param.first); });

/// Positions spread over a pixel, each with exact time, give what rays spread over pixel and time converge to.
TEST(SegmentLightCases, PositionsGiveTheVisibilityOfPixels) {
    const std::unique_ptr<Scene> scene = openScene("cubes", "");
    FrameRequest request;
    request.width = 12;
    request.height = 9;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    const SegmentOracle segments(plan);
    const std::vector<VisibilityMean> rays = Oracle(plan).pixelMeans(plan, 0, 9, 8192, 3);
    constexpr int count = 256;
    double squares = 0.0, worst = 0.0;
    int pixels = 0, partly = 0;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 12; ++x) {
            std::vector<vec2> places;
            for (int i = 0; i < count; ++i) {
                // A lattice that no line of the picture follows.
                const float across = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
                const float up = std::fmod(0.3f + 0.618034f * static_cast<float>(i), 1.0f);
                places.emplace_back(static_cast<float>(x) + across, static_cast<float>(y) + up);
            }
            double tested = 0.0, lit = 0.0;
            for (const std::vector<LitSegment>& list : segments.litByAll(plan, places))
                for (const LitSegment& s : list) tested += s.tested, lit += s.lit;
            const VisibilityMean& mean = rays[static_cast<std::size_t>(12 * y + x)];
            if (!(tested > 0.0) || !mean.exists()) continue;
            const double error = lit / tested - mean.value();
            ++pixels;
            partly += lit > 0.0 && lit < tested ? 1 : 0;
            squares += error * error;
            worst = std::max(worst, std::abs(error));
        }
    std::printf("%d pixels, %d of them partly lit: root mean square difference %.4f, worst %.4f\n", pixels, partly,
                std::sqrt(squares / pixels), worst);
    EXPECT_GT(partly, 40);
    EXPECT_LT(std::sqrt(squares / pixels), 0.006);  // 256 places a pixel, 8,192 rays
    EXPECT_LT(worst, 0.02);
}

/// A ground, a sheet that the camera looks through from behind, and a sun above both.
class OverTheGround {
  public:
    /// Heights at x = -1 and x = 1, at both ends of the shutter; the sheet slides by `slide`.
    OverTheGround(glm::dvec2 open, glm::dvec2 close, double slide) {
        scene_.quads.push_back(slidingQuad({0, 0, 0}, {0, 0, 0}, 1000.0, -1000.0, 1000.0));
        MovingQuad sheet{};
        const double x[4] = {-1, -1, 1, 1}, y[4] = {-1, 1, 1, -1};
        for (int c = 0; c < 4; ++c) {
            sheet.open[c] = {3.0 * x[c] - 0.5 * slide, 3.0 * y[c], x[c] < 0 ? open.x : open.y};
            sheet.close[c] = {3.0 * x[c] + 0.5 * slide, 3.0 * y[c], x[c] < 0 ? close.x : close.y};
        }
        scene_.quads.push_back(sheet);
        scene_.cameraOpen = scene_.cameraClose = lookAt({0, 0, 4}, {0, 0, 0}, {0, 1, 0}, 0.5, 0.01);
        scene_.lightOpen.kind = LightKind::Directional;
        scene_.lightOpen.position = scene_.lightClose.position = {0, 0, 10};
        scene_.finish();
        plan_ = FramePlanner(scene_).plan(ProceduralScene::request(64, 64, 1, 64, 1));
    }
    double litTime() const {
        const SegmentOracle oracle(plan_);
        const vec2 place(32.0f, 33.0f);
        const std::vector<SeenSegment> seen = oracle.seenBy(plan_, place);
        EXPECT_EQ(seen.size(), 1u);
        EXPECT_LT(seen[0].triangle, 2u);
        return oracle.litOver(plan_, place, seen)[0].lit;
    }
    static constexpr double clearance = 1000.0 * 0x1p-21;

  private:
    ProceduralScene scene_;
    FramePlan plan_;
};

/// A sheet that rises through the ground shadows it from the clearance on.
TEST(SegmentLightCases, BeginsWhereTheClearanceEnds) {
    const double c = OverTheGround::clearance;
    const OverTheGround rising({-c, -c}, {3.0 * c, 3.0 * c}, 0.0);
    EXPECT_NEAR(rising.litTime(), 0.5, 1e-6);
    const OverTheGround higher({c / 2, c / 2}, {3.0 * c, 3.0 * c}, 0.0);
    EXPECT_NEAR(higher.litTime(), 0.2, 1e-6);
}

/// It need not pass through the ground: its height over a receiver is a parabola that dips below the clearance.
TEST(SegmentLightCases, DipsBelowTheClearance) {
    const double c = OverTheGround::clearance;
    // It slants from left to right, then from right to left, while it slides: c / 2 + c (2 u - 1)^2 at x = 0.
    const OverTheGround dips({-5.5 * c, 6.5 * c}, {6.5 * c, -5.5 * c}, 1.0);
    EXPECT_NEAR(dips.litTime(), std::sqrt(0.5), 1e-5);
}

}  // namespace
}  // namespace timeshade
