// Both errors of a technique rest on these sums: worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

#include "core/error.h"
#include "measure/error_summary.h"
#include "measure/shadow_error.h"

namespace timeshade {
namespace {

TEST(ErrorSummary, AHalfEverywhere) {
    // A technique that says 1/2 of pixels that are lit (three) or shadowed (one): off by 1/2 in each.
    ErrorSum sum(4);
    for (std::size_t pixel = 0; pixel < 4; ++pixel) sum.add(pixel, pixel < 3 ? -0.5 : 0.5, pixel < 3 ? -0.5 : 0.5);
    const ErrorSummary e = sum.summary();
    EXPECT_EQ(e.count, 4u);
    EXPECT_EQ(e.mean, 0.5);
    EXPECT_EQ(e.rms, 0.5);
    EXPECT_EQ(e.p999, 0.5);
    EXPECT_EQ(e.meanSquareDeviation, 0.0);
    EXPECT_EQ(e.standardError, 0.0);
}

TEST(ErrorSummary, NoiseOfTheHalvesDropsOut) {
    // Values of 1/2, truths of 1/2 whose halves are off by 1/4 to either side, or to one side.
    ErrorSum sum(4);
    sum.add(0, 0.25, -0.25);
    sum.add(1, -0.25, 0.25);
    sum.add(2, 0.25, 0.25);
    sum.add(3, -0.25, -0.25);
    const ErrorSummary e = sum.summary();
    EXPECT_EQ(e.meanSquare, 0.0);
    EXPECT_EQ(e.rms, 0.0);
    EXPECT_EQ(e.mean, 0.125);
    // Each pixel's product is 1/16 or -1/16: their variance with divisor 3 is 4/3 / 256, that of the mean a quarter.
    EXPECT_DOUBLE_EQ(e.meanSquareDeviation, std::sqrt(4.0 / 3.0 / 256.0 / 4.0));
    EXPECT_DOUBLE_EQ(e.standardError, std::sqrt(e.meanSquareDeviation));

    ErrorSum opposed(1);
    opposed.add(0, 0.25, -0.25);
    EXPECT_EQ(opposed.summary().meanSquare, -0.0625);
    EXPECT_EQ(opposed.summary().rms, 0.0);
    EXPECT_EQ(opposed.summary().meanSquareDeviation, 0.0) << "one pixel tells nothing of others";
}

TEST(ErrorSummary, SamplesOfOnePixelGoTogether) {
    // Two pixels: one wrong in both of its samples, one right in both. As if there were two values, not four.
    ErrorSum sum(2);
    for (const std::size_t pixel : {0u, 0u, 1u, 1u}) sum.add(pixel, pixel == 0 ? 1.0 : 0.0, pixel == 0 ? 1.0 : 0.0);
    const ErrorSummary e = sum.summary();
    EXPECT_EQ(e.count, 4u);
    EXPECT_EQ(e.meanSquare, 0.5);
    // Sums less mean times count: 2 - 1 and 0 - 1; sqrt((1 + 1) * 2/1) / 4.
    EXPECT_DOUBLE_EQ(e.meanSquareDeviation, 0.5);
    EXPECT_DOUBLE_EQ(e.standardError, 1.0 - std::sqrt(0.5));
}

TEST(ErrorSummary, PercentileByNearestRankWithZeros) {
    ErrorSum two(2000), three(2000);
    for (std::size_t pixel = 0; pixel < 2000; ++pixel) {
        two.add(pixel, pixel < 2 ? 0.75 : 0.0, pixel < 2 ? 0.75 : 0.0);
        three.add(pixel, pixel < 3 ? -0.75 : 0.0, pixel < 3 ? -0.75 : 0.0);
    }
    EXPECT_EQ(two.summary().p999, 0.0) << "1998 of 2000 are right: 0.999 of all";
    EXPECT_EQ(three.summary().p999, 0.75);
}

TEST(ErrorSummary, NothingAndNotANumber) {
    EXPECT_EQ(ErrorSum(3).summary().count, 0u);
    EXPECT_EQ(ErrorSum(3).summary().rms, 0.0);
    ErrorSum sum(2);
    sum.add(0, 0.0, 0.0);
    sum.add(1, std::numeric_limits<double>::quiet_NaN(), 0.0);
    const ErrorSummary e = sum.summary();
    for (const double value : {e.mean, e.rms, e.p999, e.standardError, e.meanSquare, e.meanSquareDeviation})
        EXPECT_TRUE(std::isnan(value));
}

/// What an independent simulation says: a bias of 0.1 and halves with a noise of 0.2 each.
TEST(ErrorSummary, FindsABiasBelowTheNoise) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.0, 0.2);
    ErrorSum sum(40000);
    for (std::size_t pixel = 0; pixel < 40000; ++pixel) sum.add(pixel, 0.1 - noise(random), 0.1 - noise(random));
    const ErrorSummary e = sum.summary();
    EXPECT_NEAR(e.meanSquare, 0.01, 3.0 * e.meanSquareDeviation);
    EXPECT_NEAR(e.rms, 0.1, 3.0 * e.standardError);
    EXPECT_LT(e.standardError, 0.003);
    EXPECT_GT(e.mean, 0.12) << "not debiased";
    // Variance of (b - x)(b - y): 2 b^2 s^2 + s^4.
    EXPECT_NEAR(e.meanSquareDeviation, std::sqrt((2.0 * 0.01 * 0.04 + 0.0016) / 40000.0), 0.05 * e.meanSquareDeviation);
}

ReferenceVisibility fourPixels() {
    constexpr float none = ReferenceVisibility::NONE;
    return {2, 2, 64, {1.0f, 0.5f, none, 0.25f}, {1.0f, 0.5f, 0.5f, 0.75f}};
}

TEST(ShadowError, OverThePixelsThatBothHave) {
    const ReferenceVisibility reference = fourPixels();
    PixelMeans means(4);
    means.add(0, 1.0);
    means.add(0, 0.0);  // mean 1/2 where the truth is 1
    means.add(2, 1.0);  // no truth: one half saw nothing there
    means.add(3, 0.5);  // truths 1/4 and 3/4
    const ShadowError error = means.against(reference);
    EXPECT_EQ(error.error.count, 2u);
    EXPECT_EQ(error.pixelsWithoutSamples, 1u);
    EXPECT_EQ(error.pixelsWithoutReference, 1u);
    EXPECT_EQ(error.rays, 64);
    EXPECT_EQ(error.error.mean, 0.25);
    EXPECT_EQ(error.error.meanSquare, 0.5 * (0.25 - 0.0625));
    EXPECT_EQ(error.error.p999, 0.5);
}

TEST(ShadowError, WeighsValuesByTheirShareOfTheShutter) {
    ReferenceVisibility reference = fourPixels();
    PixelMeans means(4);
    means.add(1, 0.0, 0.75);
    means.add(1, 1.0, 0.25);
    EXPECT_EQ(means.against(reference).error.rms, 0.25);
    reference.first.pop_back();
    EXPECT_THROW(means.against(reference), Error);
}

}  // namespace
}  // namespace timeshade
