// The metrics themselves, with images worked out by hand: every accuracy that the program reports rests on them.

#include "measure/metrics.h"
#include "core/error.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>

namespace timeshade {
namespace {

constexpr float notANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

LinearImage filled(int width, int height, float value) {
    return {width, height, std::vector<float>(static_cast<std::size_t>(width * height * 3), value)};
}

DisplayImage filledDisplay(int width, int height, std::uint8_t value) {
    return {width, height, std::vector<std::uint8_t>(static_cast<std::size_t>(width * height * 3), value)};
}

/// 2x2. The twelve differences are 0.5, -0.5, 1, -2 and eight times 0; every number is exact in binary.
struct WorkedExample {
    LinearImage reference{2, 2, {1.0f, 1.0f, 0.0f, 2.0f, 0.5f, 0.5f, 0.5f, 0.5f, 0.0f, 0.0f, 0.0f, 0.0f}};
    LinearImage image{2, 2, {1.5f, 0.5f, 1.0f, 0.0f, 0.5f, 0.5f, 0.5f, 0.5f, 0.0f, 0.0f, 0.0f, 0.0f}};
};

void expectAllNaN(const ErrorMetrics& metrics) {
    EXPECT_TRUE(std::isnan(metrics.rmse));
    EXPECT_TRUE(std::isnan(metrics.relativeMse));
    EXPECT_TRUE(std::isnan(metrics.psnr));
    EXPECT_TRUE(std::isnan(metrics.meanAbsolute));
    EXPECT_TRUE(std::isnan(metrics.p999));
    EXPECT_TRUE(!metrics.offBy30 || std::isnan(*metrics.offBy30));
}

TEST(Metrics, TwoByTwoByHand) {
    const WorkedExample example;
    const ErrorMetrics metrics = compareImages(example.image, example.reference);
    const double meanSquare = (0.25 + 0.25 + 1.0 + 4.0) / 12.0;
    EXPECT_DOUBLE_EQ(metrics.rmse, std::sqrt(meanSquare));
    EXPECT_DOUBLE_EQ(metrics.relativeMse, (0.25 / 1.01 + 0.25 / 1.01 + 1.0 / 0.01 + 4.0 / 4.01) / 12.0);
    EXPECT_DOUBLE_EQ(metrics.psnr, 10.0 * std::log10(1.0 / meanSquare));
    EXPECT_DOUBLE_EQ(metrics.meanAbsolute, (0.5 + 0.5 + 1.0 + 2.0) / 12.0);
    EXPECT_DOUBLE_EQ(metrics.p999, 2.0);
    EXPECT_FALSE(metrics.offBy30.has_value());
}

TEST(Metrics, MeanAbsoluteIsNotMeanSquare) {
    // |d| = 0.5 everywhere: the mean of squares would be 0.25.
    const ErrorMetrics metrics = compareImages(filled(3, 2, 0.25f), filled(3, 2, 0.75f));
    EXPECT_DOUBLE_EQ(metrics.meanAbsolute, 0.5);
    EXPECT_DOUBLE_EQ(metrics.rmse, 0.5);
    EXPECT_DOUBLE_EQ(metrics.p999, 0.5);
    EXPECT_NEAR(metrics.psnr, 6.020599913279624, 1e-12);
}

TEST(Metrics, SinglePixel) {
    const ErrorMetrics metrics = compareImages({1, 1, {0.0f, 0.0f, 3.0f}}, {1, 1, {0.0f, 0.0f, 0.0f}});
    EXPECT_DOUBLE_EQ(metrics.rmse, std::sqrt(3.0));
    EXPECT_DOUBLE_EQ(metrics.meanAbsolute, 1.0);
    EXPECT_DOUBLE_EQ(metrics.p999, 3.0);
    EXPECT_DOUBLE_EQ(metrics.relativeMse, 300.0);
    EXPECT_LT(metrics.psnr, 0.0);
}

TEST(Metrics, EqualImages) {
    const WorkedExample example;
    const ErrorMetrics metrics = compareImages(example.reference, example.reference);
    EXPECT_EQ(metrics.rmse, 0.0);
    EXPECT_EQ(metrics.relativeMse, 0.0);
    EXPECT_EQ(metrics.meanAbsolute, 0.0);
    EXPECT_EQ(metrics.p999, 0.0);
    EXPECT_EQ(metrics.psnr, std::numeric_limits<double>::infinity());
}

TEST(Metrics, SymmetryAndScale) {
    const WorkedExample example;
    const ErrorMetrics there = compareImages(example.image, example.reference);
    const ErrorMetrics back = compareImages(example.reference, example.image);
    EXPECT_EQ(there.rmse, back.rmse);
    EXPECT_EQ(there.meanAbsolute, back.meanAbsolute);
    EXPECT_EQ(there.p999, back.p999);
    EXPECT_NE(there.relativeMse, back.relativeMse) << "only the reference divides";

    LinearImage image = example.image;
    LinearImage reference = example.reference;
    for (float& value : image.rgb) value *= 4.0f;
    for (float& value : reference.rgb) value *= 4.0f;
    const ErrorMetrics scaled = compareImages(image, reference);
    EXPECT_DOUBLE_EQ(scaled.rmse, 4.0 * there.rmse);
    EXPECT_DOUBLE_EQ(scaled.meanAbsolute, 4.0 * there.meanAbsolute);
    EXPECT_NEAR(scaled.psnr, there.psnr - 20.0 * std::log10(4.0), 1e-12);
}

TEST(Metrics, OrderedForAnyImage) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> value(0.0f, 2.0f);
    for (int round = 0; round < 50; ++round) {
        LinearImage image = filled(9, 5, 0.0f);
        LinearImage reference = filled(9, 5, 0.0f);
        for (float& x : image.rgb) x = value(random);
        for (float& r : reference.rgb) r = value(random);
        const ErrorMetrics metrics = compareImages(image, reference);
        EXPECT_LE(metrics.meanAbsolute, metrics.rmse);
        EXPECT_LE(metrics.rmse, metrics.p999);  // fewer than 1000 values: p999 is the largest
        EXPECT_LE(metrics.relativeMse, metrics.rmse * metrics.rmse / relativeMseEpsilon);
        EXPECT_GE(metrics.relativeMse, metrics.rmse * metrics.rmse / (4.0 + relativeMseEpsilon));
    }
}

TEST(Metrics, PercentileByNearestRank) {
    // 1000 pixels, 3000 values: rank 2997, so three outliers are left out and the fourth is not.
    const LinearImage reference = filled(100, 10, 0.0f);
    LinearImage image = filled(100, 10, 0.25f);
    image.rgb[0] = image.rgb[1500] = 5.0f;
    image.rgb[2999] = -7.0f;
    EXPECT_DOUBLE_EQ(compareImages(image, reference).p999, 0.25);
    image.rgb[1000] = 3.0f;
    EXPECT_DOUBLE_EQ(compareImages(image, reference).p999, 3.0);
}

TEST(Metrics, PercentileOnEitherSideOfAThousandValues) {
    // 333 pixels: 999 values, all of them needed to reach 99.9 %. 334 pixels: 1002 values, 1001 of them do.
    for (const int width : {333, 334}) {
        LinearImage image = filled(width, 1, 0.0f);
        image.rgb[17] = 1.0f;
        EXPECT_DOUBLE_EQ(compareImages(image, filled(width, 1, 0.0f)).p999, width == 333 ? 1.0 : 0.0);
    }
}

TEST(Metrics, NaNAndInfinityPoisonEverything) {
    const WorkedExample example;
    for (const float bad : {notANumber, infinity, -infinity}) {
        for (const std::size_t place : {0u, 5u, 11u}) {
            LinearImage broken = example.image;
            broken.rgb[place] = bad;
            expectAllNaN(compareImages(broken, example.reference));
            expectAllNaN(compareImages(example.reference, broken));
            expectAllNaN(compareImages(broken, broken));
            const DisplayImage shown = filledDisplay(2, 2, 0);
            const ErrorMetrics withDisplay = compareImages(broken, example.reference, shown, shown);
            ASSERT_TRUE(withDisplay.offBy30.has_value());
            expectAllNaN(withDisplay);
        }
    }
}

TEST(Metrics, LargestFloatsDoNotOverflow) {
    const float largest = std::numeric_limits<float>::max();
    const ErrorMetrics metrics = compareImages(filled(2, 2, largest), filled(2, 2, -largest));
    EXPECT_DOUBLE_EQ(metrics.rmse, 2.0 * static_cast<double>(largest));
}

TEST(Metrics, SizesThatDiffer) {
    EXPECT_THROW(compareImages(filled(2, 3, 0.0f), filled(3, 2, 0.0f)), Error);
    EXPECT_THROW(compareImages(filled(2, 2, 0.0f), filled(2, 3, 0.0f)), Error);
    EXPECT_THROW(compareImages(LinearImage{}, LinearImage{}), Error);
    EXPECT_THROW(compareImages(LinearImage{2, 2, {1.0f}}, filled(2, 2, 0.0f)), Error);
    EXPECT_THROW(shareOffBy(filledDisplay(2, 2, 0), filledDisplay(2, 1, 0), 30), Error);
    EXPECT_THROW(compareImages(filled(2, 2, 0.0f), filled(2, 2, 0.0f), filledDisplay(1, 2, 0), filledDisplay(1, 2, 0)),
                 Error);
    try {
        compareImages(filled(2, 3, 0.0f), filled(3, 2, 0.0f));
        FAIL();
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "cannot compare images: 2x3 pixels against 3x2, expected equal sizes");
    }
}

TEST(Metrics, ShareOffByCountsPixelsByTheirWorstChannel) {
    const DisplayImage reference = filledDisplay(2, 2, 100);
    DisplayImage image = reference;
    EXPECT_EQ(shareOffBy(image, reference, 30), 0.0);
    image.rgb[0] = 130;  // exactly 30: not counted
    EXPECT_EQ(shareOffBy(image, reference, 30), 0.0);
    image.rgb[0] = 131;
    EXPECT_EQ(shareOffBy(image, reference, 30), 0.25);
    image.rgb[1] = image.rgb[2] = 255;  // the same pixel
    EXPECT_EQ(shareOffBy(image, reference, 30), 0.25);
    image.rgb[11] = 69;  // darker counts as brighter does
    EXPECT_EQ(shareOffBy(image, reference, 30), 0.5);
    EXPECT_EQ(shareOffBy(reference, image, 30), 0.5);
    EXPECT_EQ(shareOffBy(filledDisplay(2, 2, 0), filledDisplay(2, 2, 255), 254), 1.0);

    const LinearImage linear = filled(2, 2, 0.5f);
    EXPECT_EQ(compareImages(linear, linear, image, reference).offBy30, 0.5);
}

TEST(BiasAndNoise, ByHand) {
    // One pixel, two seeds around a mean of 2 with unbiased variance 2, a reference of 5: bias² = 9 - 2 / 2.
    const std::vector<LinearImage> seeds = {filled(1, 1, 1.0f), filled(1, 1, 3.0f)};
    const BiasAndNoise found = biasAndNoise(seeds, filled(1, 1, 5.0f));
    EXPECT_DOUBLE_EQ(found.noise, std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(found.meanError, 3.0);
    EXPECT_DOUBLE_EQ(found.bias, std::sqrt(8.0));
}

TEST(BiasAndNoise, ErrorThatNoiseExplainsIsNoBias) {
    const std::vector<LinearImage> seeds = {filled(2, 2, 1.0f), filled(2, 2, 3.0f)};
    const BiasAndNoise found = biasAndNoise(seeds, filled(2, 2, 2.5f));
    EXPECT_DOUBLE_EQ(found.meanError, 0.5);
    EXPECT_EQ(found.bias, 0.0);
}

TEST(BiasAndNoise, WithoutNoiseTheBiasIsTheError) {
    const WorkedExample example;
    const std::vector<LinearImage> seeds(3, example.image);
    const BiasAndNoise found = biasAndNoise(seeds, example.reference);
    EXPECT_EQ(found.noise, 0.0);
    EXPECT_DOUBLE_EQ(found.bias, compareImages(example.image, example.reference).rmse);
    EXPECT_DOUBLE_EQ(found.meanError, found.bias);
}

TEST(BiasAndNoise, FindsBothInRandomImages) {
    // 8 seeds of 64x64: standard errors, from the 12,288 independent values, are 0.0002 for the noise and
    // 0.0005 for the bias; the tolerances are five of them.
    std::mt19937 random(5);
    std::normal_distribution<float> deviation(0.0f, 0.1f);
    const LinearImage reference = filled(64, 64, 0.5f);
    std::vector<LinearImage> seeds(8, filled(64, 64, 0.55f));
    for (LinearImage& seed : seeds) {
        for (float& value : seed.rgb) value += deviation(random);
    }
    const BiasAndNoise found = biasAndNoise(seeds, reference);
    EXPECT_NEAR(found.noise, 0.1, 0.0012);
    EXPECT_NEAR(found.bias, 0.05, 0.0025);
    EXPECT_GT(found.meanError, found.bias);
}

TEST(BiasAndNoise, RefusesAndPoisons) {
    const std::vector<LinearImage> one = {filled(2, 2, 1.0f)};
    EXPECT_THROW(biasAndNoise(one, filled(2, 2, 1.0f)), Error);
    EXPECT_THROW(biasAndNoise({}, filled(2, 2, 1.0f)), Error);
    std::vector<LinearImage> seeds = {filled(2, 2, 1.0f), filled(2, 2, 1.0f), filled(2, 1, 1.0f)};
    EXPECT_THROW(biasAndNoise(seeds, filled(2, 2, 1.0f)), Error);
    seeds[2] = filled(2, 2, 1.0f);
    seeds[1].rgb[7] = infinity;
    const BiasAndNoise found = biasAndNoise(seeds, filled(2, 2, 1.0f));
    EXPECT_TRUE(std::isnan(found.noise) && std::isnan(found.meanError) && std::isnan(found.bias));
}

TEST(LogLogSlope, OfPowerLaws) {
    const std::vector<double> x = {1.0, 4.0, 16.0, 64.0};
    for (const double power : {-2.0, -1.0, -0.5, 0.0, 3.0}) {
        std::vector<double> y;
        for (const double value : x) y.push_back(7.0 * std::pow(value, power));
        const auto slope = logLogSlope(x, y);
        ASSERT_TRUE(slope.has_value());
        EXPECT_NEAR(*slope, power, 1e-12);
    }
}

TEST(LogLogSlope, LeastSquaresByHand) {
    // In logarithms of base e: (0, 0), (1, 1), (2, 0). The best line is flat.
    const double e = std::exp(1.0);
    EXPECT_NEAR(*logLogSlope(std::vector{1.0, e, e * e}, std::vector{1.0, e, 1.0}), 0.0, 1e-12);
    // (0, 0), (1, 0), (2, 3): slope 3 / 2.
    EXPECT_NEAR(*logLogSlope(std::vector{1.0, e, e * e}, std::vector{1.0, 1.0, e * e * e}), 1.5, 1e-12);
}

TEST(LogLogSlope, LeavesOutWhatHasNoLogarithm) {
    const double bad = std::numeric_limits<double>::quiet_NaN();
    const double endless = std::numeric_limits<double>::infinity();
    const auto slope = logLogSlope(std::vector{1.0, 2.0, 0.0, 4.0, -1.0, 4.0, 4.0},
                                   std::vector{1.0, 0.0, 5.0, 0.25, 3.0, bad, endless});
    ASSERT_TRUE(slope.has_value());
    EXPECT_NEAR(*slope, -1.0, 1e-12);
}

TEST(LogLogSlope, NoneWithoutTwoPlaces) {
    EXPECT_FALSE(logLogSlope({}, {}).has_value());
    EXPECT_FALSE(logLogSlope(std::vector{2.0}, std::vector{1.0}).has_value());
    EXPECT_FALSE(logLogSlope(std::vector{2.0, 2.0}, std::vector{1.0, 3.0}).has_value());
    EXPECT_FALSE(logLogSlope(std::vector{2.0, 0.0}, std::vector{1.0, 3.0}).has_value());
    EXPECT_THROW(logLogSlope(std::vector{2.0, 0.0}, std::vector{1.0}), Error);
}

}  // namespace
}  // namespace timeshade
