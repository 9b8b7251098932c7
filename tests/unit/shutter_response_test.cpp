// The shutter's response and its integral against numerical integration, and what a plan makes of it.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "plan/frame_plan.h"
#include "shared/shutter_response.shared.h"

namespace timeshade {
namespace {

using shared::shutterExposure;
using shared::shutterWeight;

struct Response {
    std::uint32_t kind;
    float width;
    const char* name;
};

const std::vector<Response> responses{{SHUTTER_BOX, 0.0f, "box"},          {SHUTTER_TENT, 0.0f, "tent"},
                                      {SHUTTER_GAUSSIAN, 0.05f, "narrow"}, {SHUTTER_GAUSSIAN, 1.0f / 6.0f, "usual"},
                                      {SHUTTER_GAUSSIAN, 0.5f, "wide"},    {SHUTTER_GAUSSIAN, 2.0f, "widest"}};

/// w as the header defines it, in double precision.
double exactWeight(const Response& r, double u) {
    if (r.kind == SHUTTER_BOX) return 1.0;
    if (r.kind == SHUTTER_TENT) return 1.0 - std::abs(2.0 * u - 1.0);
    const double deviations = (u - 0.5) / static_cast<double>(r.width);
    return std::exp(-0.5 * deviations * deviations);
}

/// Of every step of [0, 1], the exposure until its end: Simpson's rule, whose error is below 1e-9 here. The tent's bend
/// lies between two steps.
std::vector<double> integrated(const Response& r, int steps) {
    std::vector<double> sums{0.0};
    for (int i = 0; i < steps; ++i) {
        const double a = static_cast<double>(i) / steps, b = static_cast<double>(i + 1) / steps;
        sums.push_back(sums.back() +
                       (exactWeight(r, a) + 4.0 * exactWeight(r, 0.5 * (a + b)) + exactWeight(r, b)) / (6.0 * steps));
    }
    for (double& sum : sums) sum /= sums.back();
    return sums;
}

TEST(ShutterResponse, WeighsAsItIsDefined) {
    for (const Response& r : responses) {
        SCOPED_TRACE(r.name);
        EXPECT_EQ(shutterWeight(r.kind, r.width, 0.5f), 1.0f);
        for (int i = 0; i <= 4096; ++i) {
            const float u = static_cast<float>(i) / 4096.0f;
            const double exact = std::max(exactWeight(r, static_cast<double>(u)), 1e-15);
            const double weight = static_cast<double>(shutterWeight(r.kind, r.width, u));
            // The stated 2^-15; a tent near its ends is a difference of numbers near 1.
            ASSERT_NEAR(weight, exact, std::ldexp(exact, -15) + (r.kind == SHUTTER_TENT ? 6e-8 : 1e-21)) << u;
            ASSERT_GE(weight, 0.99e-15);
            ASSERT_EQ(weight, static_cast<double>(shutterWeight(r.kind, r.width, 1.0f - u))) << "symmetric at " << u;
        }
    }
}

TEST(ShutterResponse, ExposureIsTheIntegralOfTheWeight) {
    constexpr int steps = 2048;
    for (const Response& r : responses) {
        SCOPED_TRACE(r.name);
        const std::vector<double> exact = integrated(r, steps);
        const double half = 0.5 / (std::sqrt(2.0) * static_cast<double>(r.width));
        const double stated = r.kind == SHUTTER_GAUSSIAN ? 7e-7 / std::erf(half) : 2e-7;
        double largest = 0.0;
        for (int i = 0; i <= steps; ++i) {
            const float u = static_cast<float>(i) / steps;
            const double off = static_cast<double>(shutterExposure(r.kind, r.width, u)) - exact[std::size_t(i)];
            largest = std::max(largest, std::abs(off));
        }
        RecordProperty(std::string("largest error: ") + r.name, std::to_string(largest));
        EXPECT_LE(largest, stated);
        EXPECT_EQ(shutterExposure(r.kind, r.width, 0.0f), 0.0f);
        EXPECT_NEAR(static_cast<double>(shutterExposure(r.kind, r.width, 0.5f)), 0.5, stated);
        EXPECT_EQ(shutterExposure(r.kind, r.width, 1.0f), 1.0f);
    }
}

TEST(ShutterResponse, ExposureOfTheCatalogueFirstCase) {
    // Dark from .3 to .7. Of a tent's exposure 2 x .3 x .3 lies before that, and as much behind.
    const auto dark = [](const Response& r) {
        return static_cast<double>(shutterExposure(r.kind, r.width, 0.7f) - shutterExposure(r.kind, r.width, 0.3f));
    };
    EXPECT_NEAR(dark(responses[0]), 0.4, 1e-7);
    EXPECT_NEAR(dark(responses[1]), 0.64, 1e-6);
    // erf(.2 / (sqrt 2 / 6)) / erf(.5 / (sqrt 2 / 6))
    EXPECT_NEAR(dark(responses[3]), std::erf(1.2 / std::sqrt(2.0)) / std::erf(3.0 / std::sqrt(2.0)), 1e-6);
}

TEST(ShutterResponse, ErrorFunctionIsWithinItsStatedError) {
    for (int i = 0; i <= 800000; ++i) {
        const float x = 1e-5f * static_cast<float>(i);
        ASSERT_NEAR(static_cast<double>(shared::errorFunction(x)), std::erf(static_cast<double>(x)), 7e-7) << x;
    }
}

FramePlan planOf(Scene& scene, ShutterResponse response, double width = 1.0 / 6.0, bool closed = false) {
    FrameRequest request = ProceduralScene::request(8, 6, 4, 64, 1);
    request.shutter.response = response;
    request.shutter.width = width;
    if (closed) request.shutter.length = 0.0;
    return FramePlanner(scene).plan(request);
}

TEST(ShutterResponse, ReachesTheBlockWhereSomethingMoves) {
    Scene& moving = *closedFormCase("quad_sweeps_point").scene;
    EXPECT_EQ(planOf(moving, ShutterResponse::Box).block.response, SHUTTER_BOX);
    EXPECT_EQ(planOf(moving, ShutterResponse::Tent).block.response, SHUTTER_TENT);
    EXPECT_EQ(planOf(moving, ShutterResponse::Tent).block.responseWidth, 0.0f) << "a tent has none";
    EXPECT_EQ(planOf(moving, ShutterResponse::Gaussian, 0.25).block.response, SHUTTER_GAUSSIAN);
    EXPECT_EQ(planOf(moving, ShutterResponse::Gaussian, 0.25).block.responseWidth, 0.25f);
    // Also where only the light moves, or the receiver; not where nothing does.
    EXPECT_EQ(planOf(*closedFormCase("light_slides").scene, ShutterResponse::Tent).block.response, SHUTTER_TENT);
    EXPECT_EQ(planOf(*closedFormCase("receiver_slides").scene, ShutterResponse::Tent).block.response, SHUTTER_TENT);
    EXPECT_EQ(planOf(*closedFormCase("static_all").scene, ShutterResponse::Tent).block.response, SHUTTER_BOX);
    EXPECT_EQ(planOf(moving, ShutterResponse::Gaussian, 0.25, true).block.response, SHUTTER_BOX);
    EXPECT_EQ(planOf(moving, ShutterResponse::Gaussian, 0.25, true).block.responseWidth, 0.0f);
}

/// Of a frame that is drawn many times: all renders together are the whole picture, and each counts by its instant.
TEST(ShutterResponse, WeightsOfRendersMakeOneWhole) {
    Scene& scene = *closedFormCase("quad_sweeps_point").scene;
    for (const auto response : {ShutterResponse::Box, ShutterResponse::Tent, ShutterResponse::Gaussian}) {
        const FramePlan plan = planOf(scene, response);
        for (const int renders : {1, 2, 7, 64}) {
            double sum = 0.0, weights = 0.0;
            std::vector<double> shares;
            for (int m = 0; m < renders; ++m) {
                const shared::FrameBlock block = planAtInstant(plan, m, renders).block;
                EXPECT_EQ(block.response, plan.block.response) << "the shutter's, for means over time";
                const float weight = shutterWeight(block.response, block.responseWidth, block.timeBase);
                shares.push_back(static_cast<double>(block.weight) / static_cast<double>(weight));
                sum += static_cast<double>(block.weight);
                weights += static_cast<double>(weight);
            }
            EXPECT_NEAR(sum, 1.0, 1e-6) << renders << " renders";
            for (const double share : shares) EXPECT_NEAR(share * weights, 1.0, 1e-6);
            if (response != ShutterResponse::Box) continue;
            EXPECT_EQ(planAtInstant(plan, 0, renders).block.weight, 1.0f / static_cast<float>(renders));
        }
    }
}

}  // namespace
}  // namespace timeshade
