// Equal time and equal error: the right sample count on costs that are known, with steps and with noise, and a plain no
// where nothing comes near.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "measure/equal_search.h"
#include "shared/hash.shared.h"

namespace timeshade {
namespace {

std::vector<int> samples(int most = 32) {
    std::vector<int> sampleCounts(static_cast<std::size_t>(most));
    std::iota(sampleCounts.begin(), sampleCounts.end(), 1);
    return sampleCounts;
}

/// Ratios of a value to the first's. `noise`: of single measurements, as a share, up or down by a hash; none of those
/// that are made closely.
MeasureRatios measuring(const std::function<double(int)>& value, double first, double noise = 0.0,
                        std::uint32_t seed = 0) {
    return [=, count = 0u](const std::vector<int>& sampleCounts, bool closely) mutable {
        std::vector<double> ratios;
        for (const int sampleCount : sampleCounts) {
            const double lot = shared::hashWords({seed, ++count, 5u}).x / 4294967296.0;
            ratios.push_back(value(sampleCount) / first * (closely ? 1.0 : 1.0 + noise * (2.0 * lot - 1.0)));
        }
        return ratios;
    };
}

/// By trying all of them.
int nearest(const std::vector<int>& sampleCounts, const std::function<double(int)>& value, double first) {
    int best = sampleCounts.front();
    for (const int sampleCount : sampleCounts)
        if (std::abs(std::log(value(sampleCount) / first)) < std::abs(std::log(value(best) / first)))
            best = sampleCount;
    return best;
}

double linear(int sampleCount) { return 10.0 + 3.0 * sampleCount; }

TEST(EqualTime, FindsTheNearestOfALinearCost) {
    for (double first = 12.0; first < 110.0; first += 0.7) {
        const EqualFind find = findEqualTime(samples(), measuring(linear, first));
        EXPECT_EQ(find.chosen.sampleCount, nearest(samples(), linear, first)) << first;
        EXPECT_DOUBLE_EQ(find.chosen.ratio, linear(find.chosen.sampleCount) / first);
        EXPECT_EQ(find.found, std::abs(find.chosen.ratio - 1.0) <= 0.05) << first;
        ASSERT_TRUE(find.fewer || find.more);
        if (find.fewer && find.more) {
            EXPECT_EQ(find.fewer->sampleCount + 1, find.more->sampleCount);
            EXPECT_LT(find.fewer->ratio, 1.0);
            EXPECT_GE(find.more->ratio, 1.0);
        }
    }
}

TEST(EqualTime, OfAPlateauTheFewest) {
    const auto steps = [](int sampleCount) { return 10.0 * ((sampleCount + 3) / 4); };  // 1 to 4 alike, 5 to 8 ...
    const EqualFind find = findEqualTime(samples(), measuring(steps, 30.0));
    EXPECT_TRUE(find.found);
    EXPECT_EQ(find.chosen.sampleCount, 9);
    EXPECT_DOUBLE_EQ(find.chosen.ratio, 1.0);
}

TEST(EqualTime, NoiseOfTheSearchDoesNotDecide) {
    int wrong = 0;
    for (std::uint32_t seed = 0; seed < 200; ++seed)
        for (const int wanted : {1, 2, 3, 5, 8, 12, 20, 31}) {
            const EqualFind find = findEqualTime(samples(), measuring(linear, linear(wanted), 0.1, seed));
            wrong += find.chosen.sampleCount != wanted ? 1 : 0;
            EXPECT_NEAR(find.chosen.sampleCount, wanted, 1);
        }
    EXPECT_EQ(wrong, 0);
}

TEST(EqualTime, SaysWhereNothingComesNear) {
    const EqualFind find = findEqualTime(samples(), measuring([](int n) { return 8.0 * n; }, 36.0));
    EXPECT_FALSE(find.found);
    EXPECT_FALSE(find.isEqual());
    EXPECT_EQ(find.fewer, (EqualTrial{4, 32.0 / 36.0}));
    EXPECT_EQ(find.more, (EqualTrial{5, 40.0 / 36.0}));
    EXPECT_EQ(find.chosen, *find.more);  // by ratio
}

TEST(EqualTime, SaysWhichEndIsBeyond) {
    const EqualFind least = findEqualTime(samples(), measuring(linear, 5.0));
    EXPECT_FALSE(least.found || least.fewer);
    EXPECT_EQ(least.chosen.sampleCount, 1);
    EXPECT_EQ(least.more, least.chosen);
    const EqualFind most = findEqualTime(samples(), measuring(linear, 500.0));
    EXPECT_FALSE(most.found || most.more);
    EXPECT_EQ(most.chosen.sampleCount, 32);
    EXPECT_EQ(most.fewer, most.chosen);
    // An end that comes near is a find, and one that is only as near as the search takes for one is not.
    EXPECT_TRUE(findEqualTime(samples(), measuring(linear, 12.7)).found);
    EXPECT_FALSE(findEqualTime(samples(), measuring(linear, 11.5)).found);
}

TEST(EqualTime, OneSampleCountAlone) {
    const EqualFind find = findEqualTime({4}, measuring(linear, 22.0));
    EXPECT_TRUE(find.found);
    EXPECT_EQ(find.chosen.sampleCount, 4);
}

TEST(EqualTime, EndsWhateverIsMeasured) {
    int measured = 0;
    const auto odd = [&](const std::vector<int>& sampleCounts, bool) {
        std::vector<double> ratios;
        for (std::size_t i = 0; i < sampleCounts.size(); ++i) ratios.push_back(++measured % 2 == 0 ? 3.0 : 0.3);
        return ratios;
    };
    const EqualFind find = findEqualTime(samples(), odd);
    EXPECT_FALSE(find.found);
    EXPECT_LT(measured, 40);
}

TEST(EqualError, TheFewestThatHaveNoMore) {
    const auto noise = [](int sampleCount) { return 1.0 / sampleCount; };
    for (int wanted = 1; wanted <= 32; ++wanted) {
        const EqualFind find = findEqualError(samples(), measuring(noise, noise(wanted)));
        int fewest = 1;
        while (noise(fewest) > 1.05 * noise(wanted)) ++fewest;
        EXPECT_TRUE(find.found);
        EXPECT_EQ(find.chosen.sampleCount, fewest) << wanted;
        EXPECT_LE(find.chosen.ratio, 1.05);
        EXPECT_EQ(find.fewer.has_value(), fewest > 1);
        if (find.fewer) {
            EXPECT_GT(find.fewer->ratio, 1.05);
        }
    }
}

TEST(EqualError, LessThanEqualIsFoundButNotEqual) {
    const EqualFind find = findEqualError(samples(), measuring([](int n) { return 1.0 / n; }, 0.4));
    EXPECT_TRUE(find.found);
    EXPECT_FALSE(find.isEqual());
    EXPECT_EQ(find.chosen.sampleCount, 3);
    const EqualFind at1 = findEqualError(samples(), measuring([](int n) { return 1.0 / n; }, 4.0));
    EXPECT_TRUE(at1.found);
    EXPECT_FALSE(at1.fewer);
    EXPECT_EQ(at1.chosen.sampleCount, 1);
}

TEST(EqualError, BiasIsNeverReached) {
    const auto biased = [](int sampleCount) { return 0.08 + 0.1 / sampleCount; };
    const EqualFind find = findEqualError(samples(), measuring(biased, 0.03));
    EXPECT_FALSE(find.found || find.more);
    EXPECT_EQ(find.chosen.sampleCount, 32);
    // The least of all that were tried, though it was not the last.
    const EqualFind rising = findEqualError(samples(), measuring([](int n) { return 0.1 + 0.01 * n; }, 0.03));
    EXPECT_FALSE(rising.found);
    EXPECT_EQ(rising.chosen.sampleCount, 1);
    // The first has none at all.
    const double infinity = std::numeric_limits<double>::infinity();
    const EqualFind none = findEqualError(samples(), measuring([&](int) { return infinity; }, 1.0));
    EXPECT_FALSE(none.found);
}

}  // namespace
}  // namespace timeshade
