// The oracle's means against closed forms: the edge of a half-plane's shadow sweeps over a ground.
#include <algorithm>
#include <cmath>
#include <memory>

#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "oracle/oracle.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {
namespace {

constexpr int side = 16;

/// A light at (0, 0, 10), a caster at z = 5 that reaches from far left to x = c(u), which goes from -1/2 to 1/2, and a
/// ground at z = 0: what of it lies at x is lit where x > e(u) = 2 c(u) = -1 + 2 u. The camera looks down from z = 2,
/// below the caster. The ground may slide along x.
class SweepingEdge {
  public:
    explicit SweepingEdge(double groundMoves = 0.0, bool step = false) {
        scene_.quads.push_back(slidingQuad({0.0, 0.0, 0.0}, {groundMoves, 0.0, 0.0}, 8.0, -8.0, 8.0));
        scene_.quads.push_back(slidingQuad({-4.5, 0.0, 5.0}, {-3.5, 0.0, 5.0}, 4.0, -8.0, 8.0));
        // Its edge and that of its shadow lie at x = 0 for camera and light alike: it hides the ground on the left.
        if (step) scene_.quads.push_back(slidingQuad({-2.0, 0.0, 0.5}, {-2.0, 0.0, 0.5}, 2.0, -8.0, 8.0));
        scene_.cameraOpen = scene_.cameraClose =
            lookAt({0.0, 0.0, 2.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, fieldOfView, 0.01);
        scene_.lightOpen.position = scene_.lightClose.position = {0.0, 0.0, 10.0};
        scene_.lightOpen.outerConeAngle = scene_.lightClose.outerConeAngle = 0.45;
        scene_.finish();
        planner_ = std::make_unique<FramePlanner>(scene_);
    }

    FramePlan plan(int width, int height, int strata) const {
        return planner_->plan(ProceduralScene::request(width, height, strata, 64, 3));
    }
    /// Where a column of a picture of so many begins on the ground; the next one begins where it ends.
    static double begin(int column, int columns) {
        return 2.0 * std::tan(0.5 * fieldOfView) * (2.0 * column / columns - 1.0);
    }

  private:
    static constexpr double fieldOfView = 0.8;
    ProceduralScene scene_;
    std::unique_ptr<FramePlanner> planner_;
};

/// Of the ground from a to b, the share that is lit at time u.
double litShareAt(double a, double b, double u) { return std::clamp((b - (2.0 * u - 1.0)) / (b - a), 0.0, 1.0); }

/// Its mean over a part of the shutter: exact but for the steps in which an end of the range is passed.
double litShareOver(double a, double b, double from, double to) {
    constexpr int steps = 4096;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i) sum += litShareAt(a, b, from + (to - from) * (i + 0.5) / steps);
    return sum / steps;
}

TEST(OracleMeans, ConvergedPixelsOfASweepingEdge) {
    const SweepingEdge scene;
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    const std::vector<VisibilityMean> means = oracle.pixelMeans(plan, 0, side, 1024, 5);
    ASSERT_EQ(means.size(), std::size_t{side} * side);
    double squares = 0.0;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const VisibilityMean& mean = means[static_cast<std::size_t>(y * side + x)];
            ASSERT_EQ(mean.tested, 1024u);
            const double a = SweepingEdge::begin(x, side), b = SweepingEdge::begin(x + 1, side);
            // The ends -1 and 1 of the edge's path lie outside the picture.
            ASSERT_NEAR(litShareOver(a, b, 0.0, 1.0), 0.5 * (0.5 * (a + b) + 1.0), 1e-6);
            const double difference = mean.value() - 0.5 * (0.5 * (a + b) + 1.0);
            ASSERT_LT(std::abs(difference), 0.02) << x << ", " << y;
            squares += difference * difference;
        }
    // Stratified in time: only the rays while the edge is inside the pixel are random, one in 10 or so. Independent
    // rays would have a deviation of 0.016.
    EXPECT_LT(std::sqrt(squares / (side * side)), 0.005);
}

TEST(OracleMeans, RowsOfAPictureAreItsRows) {
    const SweepingEdge scene;
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    const std::vector<VisibilityMean> all = oracle.pixelMeans(plan, 0, side, 40, 5),
                                      some = oracle.pixelMeans(plan, 7, 3, 40, 5),
                                      other = oracle.pixelMeans(plan, 7, 3, 40, 6);
    std::size_t different = 0;
    for (std::size_t i = 0; i < some.size(); ++i) {
        ASSERT_EQ(some[i].lit, all[7 * side + i].lit);
        ASSERT_EQ(some[i].tested, 40u);
        different += some[i].lit != other[i].lit ? 1u : 0u;
    }
    EXPECT_GT(different, some.size() / 4) << "another seed";
}

/// All samples of a frame that are tested, and the mean over a footprint of each.
struct Means {
    std::vector<SampleFootprint> footprints;
    std::vector<OracleAnswer> answers;
    std::vector<VisibilityMean> means;
};

template <class Shape>
Means meansOver(const Oracle& oracle, const FramePlan& plan, std::uint32_t rays, const Shape& shape) {
    Means found;
    const std::vector<std::uint32_t> ids = oracle.tracePrimaries(plan);
    const std::vector<OracleAnswer> answers = oracle.answer(plan, ids);
    const glm::uvec2 size = plan.block.imageSize;
    for (std::uint32_t i = 0; i < ids.size(); ++i) {
        if (!answers[i].tested) continue;
        SampleFootprint over;
        over.sample = {i % size.x, i / size.x % size.y, i / (size.x * size.y)};
        over.triangle = ids[i];
        shape(over, answers[i]);
        found.footprints.push_back(over);
        found.answers.push_back(answers[i]);
    }
    found.means = oracle.footprintMeans(plan, found.footprints, rays, 11);
    return found;
}

/// A ground that slides by one unit: the edge passes a point that is at x at time t when x + u - t = 2 u - 1.
/// What a pixel should show is the mean over its area, wherever its samples lie.
TEST(OracleMeans, PixelsAreMeansOverTheirArea) {
    const SweepingEdge scene;
    FramePlan plan = scene.plan(side, side, 4);
    const auto litOf = [&] {
        std::vector<std::uint32_t> lit;
        for (const VisibilityMean& mean : Oracle(plan).pixelMeans(plan, 0, side, 64, 5)) lit.push_back(mean.lit);
        return lit;
    };
    const std::vector<std::uint32_t> anywhere = litOf();
    plan.request.pixelCentres = true;
    plan.block.pixelCentres = 1;
    EXPECT_EQ(litOf(), anywhere);
}

TEST(OracleMeans, APointIsFollowedOnItsTriangle) {
    const SweepingEdge scene(1.0);
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    const Means found = meansOver(oracle, plan, 128, [](SampleFootprint& over, const OracleAnswer&) {
        over.from = 0.0f;
        over.to = 1.0f;
    });
    ASSERT_GT(found.means.size(), 900u);
    for (std::size_t i = 0; i < found.means.size(); ++i) {
        const OracleAnswer& at = found.answers[i];
        const double x = at.position.x + plan.origin.x;
        const double exact = std::clamp(x - static_cast<double>(at.time) + 1.0, 0.0, 1.0);
        ASSERT_EQ(found.means[i].tested, 128u);
        // One end of the shadow: the one stratum of 128 that it falls into is left to chance.
        ASSERT_NEAR(found.means[i].value(), exact, 1.0 / 128.0 + 1e-9);
    }
}

TEST(OracleMeans, AStratumIsNotTheShutter) {
    const SweepingEdge scene;
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    const Means found = meansOver(oracle, plan, 128, [](SampleFootprint& over, const OracleAnswer&) {
        over.from = 0.25f * static_cast<float>(over.sample.stratum);
        over.to = over.from + 0.25f;
    });
    std::size_t fractions = 0;
    for (std::size_t i = 0; i < found.means.size(); ++i) {
        const double from = static_cast<double>(found.footprints[i].from);
        const double passed = 0.5 * (found.answers[i].position.x + plan.origin.x + 1.0);  // when the edge does
        const double exact = std::clamp((passed - from) / 0.25, 0.0, 1.0);
        ASSERT_NEAR(found.means[i].value(), exact, 1.0 / 128.0 + 1e-6);
        fractions += exact > 0.0 && exact < 1.0 ? 1u : 0u;
    }
    EXPECT_GT(fractions, found.means.size() / 10);
}

TEST(OracleMeans, AnInstantAtAPointIsTheAnswer) {
    const SweepingEdge scene(1.0);
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    const Means found = meansOver(
        oracle, plan, 8, [](SampleFootprint& over, const OracleAnswer& answer) { over.from = over.to = answer.time; });
    for (std::size_t i = 0; i < found.means.size(); ++i)
        ASSERT_EQ(found.means[i].value(), found.answers[i].lit ? 1.0 : 0.0);
}

TEST(OracleMeans, WhatThePixelsAreaSeesAtAnInstantAndOverAStratum) {
    const SweepingEdge scene(1.0);  // what the pixel sees slides past: the shadow over a place is the same
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    for (const bool instant : {true, false}) {
        const Means found = meansOver(oracle, plan, 1024, [&](SampleFootprint& over, const OracleAnswer& answer) {
            over.space = SampleFootprint::Space::PixelSurface;
            over.from = instant ? answer.time : 0.25f * static_cast<float>(over.sample.stratum);
            over.to = instant ? answer.time : over.from + 0.25f;
        });
        double squares = 0.0;
        for (std::size_t i = 0; i < found.means.size(); ++i) {
            const SampleFootprint& over = found.footprints[i];
            const auto column = static_cast<int>(over.sample.x);
            const double a = SweepingEdge::begin(column, side), b = SweepingEdge::begin(column + 1, side);
            const double exact = litShareOver(a, b, static_cast<double>(over.from), static_cast<double>(over.to));
            // Places of the shared pattern are spread evenly: nearer than independent ones, which stray by up to 0.06.
            ASSERT_NEAR(found.means[i].value(), exact, 0.04);
            squares += (found.means[i].value() - exact) * (found.means[i].value() - exact);
        }
        EXPECT_LT(std::sqrt(squares / static_cast<double>(found.means.size())), 0.006);
    }
}

/// A step whose edge stands over the pixel's middle: what its other side sees belongs to another surface.
TEST(OracleMeans, ASurfaceIsOneInstance) {
    const SweepingEdge scene(0.0, true);
    const FramePlan plan = scene.plan(1, 9, 4);
    const Oracle oracle(plan);
    const Means found = meansOver(oracle, plan, 1024, [](SampleFootprint& over, const OracleAnswer& answer) {
        over.space = SampleFootprint::Space::PixelSurface;
        over.from = over.to = answer.time;
    });
    const double height = 2.0 * std::tan(0.4), width = height / 9.0;  // half of what the picture sees on the ground
    std::size_t onGround = 0, onStep = 0;
    for (std::size_t i = 0; i < found.means.size(); ++i) {
        const double u = static_cast<double>(found.answers[i].time);
        const bool ground = found.footprints[i].triangle < 2;
        // At the step's height, z = 1/2, the edge of the shadow is at 1.9 c(u) and the picture's at 3/4 of it.
        const double exact =
            ground ? litShareAt(0.0, width, u) : std::clamp((0.0 - 0.95 * (2.0 * u - 1.0)) / (0.75 * width), 0.0, 1.0);
        ASSERT_NEAR(found.means[i].tested, 512.0, 16.0);
        ASSERT_NEAR(found.means[i].value(), exact, 0.05);
        ++(ground ? onGround : onStep);
    }
    EXPECT_GT(onGround, 5u);
    EXPECT_GT(onStep, 5u);
}

/// Of the shutter's exposure, the part from a to b of a tent.
double tentShare(double a, double b) {
    const auto until = [](double u) { return u < 0.5 ? 2.0 * u * u : 1.0 - 2.0 * (1.0 - u) * (1.0 - u); };
    return until(b) - until(a);
}

FramePlan withTent(FramePlan plan) {
    plan.block.response = SHUTTER_TENT;
    return plan;
}

TEST(OracleMeans, RaysCountAsTheShutterResponds) {
    const SweepingEdge scene(1.0);
    const FramePlan plan = withTent(scene.plan(side, side, 4));
    const Oracle oracle(plan);
    const Means found = meansOver(oracle, plan, 128, [](SampleFootprint& over, const OracleAnswer&) {
        over.from = over.sample.stratum < 2 ? 0.0f : 0.25f * static_cast<float>(over.sample.stratum);
        over.to = over.sample.stratum < 2 ? 1.0f : over.from + 0.25f;
    });
    ASSERT_GT(found.means.size(), 900u);
    for (std::size_t i = 0; i < found.means.size(); ++i) {
        const double from = static_cast<double>(found.footprints[i].from),
                     to = static_cast<double>(found.footprints[i].to);
        const double x = found.answers[i].position.x + plan.origin.x;
        const double passed = std::clamp(x - static_cast<double>(found.answers[i].time) + 1.0, from, to);
        ASSERT_EQ(found.means[i].tested, 128u);
        // Of the weights the ends of a stratum count at most as 2 to 1, those of the shutter 2 to the mean's 1; and the
        // sum of the weights itself is by chance.
        ASSERT_NEAR(found.means[i].value(), tentShare(from, passed) / tentShare(from, to), 2.0 / 128.0 + 2e-3);
    }
}

TEST(OracleMeans, PixelsCountAsTheShutterResponds) {
    const SweepingEdge scene;
    const FramePlan plan = withTent(scene.plan(side, side, 4));
    const std::vector<VisibilityMean> means = Oracle(plan).pixelMeans(plan, 0, side, 1024, 5);
    for (int x = 0; x < side; ++x) {
        double exact = 0.0;
        constexpr int steps = 4096;
        for (int i = 0; i < steps; ++i) {
            const double u = (i + 0.5) / steps;
            exact += tentShare(u - 0.5 / steps, u + 0.5 / steps) *
                     litShareAt(SweepingEdge::begin(x, side), SweepingEdge::begin(x + 1, side), u);
        }
        for (int y = 0; y < side; ++y)
            ASSERT_NEAR(means[static_cast<std::size_t>(y * side + x)].value(), exact, 0.03) << x << ", " << y;
    }
}

TEST(OracleMeans, NothingSeenHasNoMean) {
    const SweepingEdge scene;
    const FramePlan plan = scene.plan(side, side, 4);
    const Oracle oracle(plan);
    SampleFootprint over;
    const std::vector<VisibilityMean> means = oracle.footprintMeans(plan, {&over, 1}, 16, 1);
    ASSERT_EQ(means.size(), 1u);
    EXPECT_FALSE(means[0].exists());
    EXPECT_TRUE(std::isnan(means[0].value()));
}

}  // namespace
}  // namespace timeshade
