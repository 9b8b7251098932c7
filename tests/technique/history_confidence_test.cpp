// Confidence and smoothing of the technique `history` against their closed forms.
#include <gtest/gtest.h>

#include "passes/seen_body.h"
#include "shared/sample_pattern.shared.h"
#include "support/drawn_view.h"
#include "technique/history_scenes.h"
#include "techniques/history/map_raster.h"

namespace timeshade {
namespace {

TEST(Confidence, IsOneAtCentresAndZeroAtBorders) {
    for (const float x : {0.5f, 7.5f, 511.5f}) EXPECT_EQ(shared::shadowTestConfidence({x, x + 3.0f}), 1.0f);
    for (const float t : {0.0f, 0.2f, 0.5f, 0.93f}) {
        EXPECT_EQ(shared::shadowTestConfidence({4.0f, 9.0f + t}), 0.0f) << t;
        EXPECT_EQ(shared::shadowTestConfidence({4.0f + t, 9.0f}), 0.0f) << t;
    }
    EXPECT_FLOAT_EQ(shared::shadowTestConfidence({2.75f, 2.5f}), 0.5f);
    EXPECT_FLOAT_EQ(shared::shadowTestConfidence({2.625f, 2.25f}), 0.5f);
}

/// The mean of conf^m (Scherzer, Jeschke and Wimmer 2007, equation 6) over a texel is 2 / ((m + 1) (m + 2)).
TEST(Confidence, WeightsHaveTheirClosedFormMean) {
    for (const float m : {1.0f, 3.0f, 15.0f}) {
        double sum = 0.0;
        constexpr int side = 400;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x)
                sum += static_cast<double>(shared::confidenceWeight(
                    shared::shadowTestConfidence((glm::vec2(x, y) + 0.5f) / static_cast<float>(side)), m));
        const double exact = 2.0 / ((static_cast<double>(m) + 1.0) * (static_cast<double>(m) + 2.0));
        EXPECT_NEAR(sum / (side * side), exact, 2e-3 * exact) << m;
        EXPECT_NEAR(exact * static_cast<double>(shared::confidenceWeightScale(m)), 1.0, 1e-6);
    }
}

/// The view is equation 5 in the map as it is turned, shifted and fitted in this frame: computed again from the plan
/// alone.
TEST(Confidence, IsThatOfTheTurnedMap) {
    const auto scene = boardScene();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(24, 18, 64));
    const auto technique = makeHistory();
    setFromText(*technique, "jitter", "2");
    setFromText(*technique, "try_triangles", "off");  // whose hits are sure anywhere
    for (std::uint32_t frame = 0; frame < 4; ++frame) {
        const std::vector<float> view = drawnView(plan, *technique, "confidence");
        const glm::dmat3 map = mapRaster(plan, MapFit::Seen, MapJitter::ShiftAndTurn, frame).mapFromPlane;
        int compared = 0;
        for (int y = 0; y < 18; ++y)
            for (int x = 0; x < 24; ++x) {
                const float shown = view[static_cast<std::size_t>(y * 24 + x)];
                if (shown < 0.0f) continue;
                const glm::vec3 pattern =
                    shared::cameraSample(glm::uvec2(x, y), 0u, plan.block.seed, plan.block.pixelCentres);
                const ViewEnd& camera = plan.camera.open;
                const glm::dvec3 ray = camera.corner + camera.right * ((x + static_cast<double>(pattern.x)) / 24) +
                                       camera.up * ((y + static_cast<double>(pattern.y)) / 18);
                const glm::dvec3 onFloor = camera.eye - ray * ((camera.eye.z + plan.origin.z) / ray.z);
                const glm::dvec3 h = map * glm::dvec3(onMapPlane(plan.light, onFloor), 1.0);
                const glm::dvec2 texel = glm::dvec2(h) / h.z * 64.0;
                ASSERT_NEAR(shown, shared::shadowTestConfidence(glm::vec2(texel)), 2e-3) << x << ", " << y;
                ++compared;
            }
        EXPECT_GT(compared, 300);
    }
}

/// Exponential smoothing of noisy tests (Scherzer, Jeschke and Wimmer 2007, equation 3) never averages more than 7 of
/// them; weighted sums average in proportion to the number of frames (docs/numerics.md).
TEST(Smoothing, EffectiveSamplesFollowTheirFormula) {
    Lots lots;
    for (const double m : {3.0, 15.0}) {
        double smoothedSquares = 0.0, sumSquares = 0.0;
        constexpr int chains = 4000, steps = 300;
        for (int chain = 0; chain < chains; ++chain) {
            float past = 0.0f;
            double weighted = 0.0, weights = 0.0;
            for (int step = 0; step < steps; ++step) {
                const float f = lots.next() < 0.5 ? -1.0f : 1.0f;  // variance 1
                const glm::vec2 position(static_cast<float>(lots.next()), static_cast<float>(lots.next()));
                const float w = shared::confidenceWeight(shared::shadowTestConfidence(position), static_cast<float>(m));
                past = shared::smoothed(past, f, w);
                weighted += static_cast<double>(w * f);
                weights += static_cast<double>(w);
            }
            smoothedSquares += static_cast<double>(past * past);
            sumSquares += weighted * weighted / (weights * weights);
        }
        const double limit = 4.0 * (2.0 * m + 1.0) / (m + 2.0) - 1.0;
        const double ofSums = 4.0 * (2.0 * m + 1.0) / ((m + 1.0) * (m + 2.0) * (m + 2.0)) * steps;
        // The standard error of a variance over 4,000 chains is 2.2 %; at m = 15 some chains have hardly begun after
        // 300 frames.
        EXPECT_NEAR(chains / smoothedSquares, limit, 0.10 * limit) << "m = " << m;
        EXPECT_NEAR(chains / sumSquares, ofSums, 0.20 * ofSums) << "m = " << m;
    }
}

}  // namespace
}  // namespace timeshade
