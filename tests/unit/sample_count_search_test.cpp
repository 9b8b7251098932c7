// The search for an equal: the right sample count, few measurements, and a plain word where there is none.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "measure/sample_count_search.h"

namespace timeshade {
namespace {

std::vector<int> samples() {
    std::vector<int> sampleCounts(32);
    std::iota(sampleCounts.begin(), sampleCounts.end(), 1);
    return sampleCounts;
}

/// Runs the search to its end; how many measurements it took.
int run(SampleCountSearch& search, const std::function<double(int)>& value) {
    int measurements = 0;
    while (const auto sampleCount = search.next()) {
        search.measured(value(*sampleCount));
        if (++measurements > 100) ADD_FAILURE() << "the search does not end";
        if (measurements > 100) break;
    }
    return measurements;
}

TEST(SampleCountSearch, FindsEverySampleCount) {
    for (int wanted = 1; wanted <= 32; ++wanted) {
        SampleCountSearch time(samples(), 10.0 + 3.0 * wanted, SampleCountSearch::Value::Rises);
        EXPECT_LE(run(time, [](int sampleCount) { return 10.0 + 3.0 * sampleCount; }), 10);
        EXPECT_EQ(time.outcome(), SampleCountSearch::Outcome::Found);
        EXPECT_EQ(time.sampleCount(), wanted);
        SampleCountSearch error(samples(), 1.0 / wanted, SampleCountSearch::Value::Falls);
        EXPECT_LE(run(error, [](int sampleCount) { return 1.0 / sampleCount; }), 10);
        EXPECT_EQ(error.sampleCount(), wanted);
        EXPECT_DOUBLE_EQ(error.value(), 1.0 / wanted);
    }
}

TEST(SampleCountSearch, TakesTheNearerNeighbourByRatio) {
    // 28.4 lies above the geometric mean of 20 and 40, and below the arithmetic one.
    SampleCountSearch search({1, 2, 4, 8}, 28.4, SampleCountSearch::Value::Rises);
    run(search, [](int sampleCount) { return 10.0 * sampleCount; });
    EXPECT_EQ(search.outcome(), SampleCountSearch::Outcome::Found);
    EXPECT_EQ(search.sampleCount(), 4);
}

TEST(SampleCountSearch, SaysWhereTheTargetIsOutOfRange) {
    const auto time = [](int sampleCount) { return 10.0 * sampleCount; };
    SampleCountSearch least(samples(), 5.0, SampleCountSearch::Value::Rises);
    EXPECT_EQ(run(least, time), 1);
    EXPECT_EQ(least.outcome(), SampleCountSearch::Outcome::LeastTooMuch);
    EXPECT_EQ(least.sampleCount(), 1);
    SampleCountSearch most(samples(), 500.0, SampleCountSearch::Value::Rises);
    EXPECT_EQ(run(most, time), 6);
    EXPECT_EQ(most.outcome(), SampleCountSearch::Outcome::MostTooLittle);
    EXPECT_EQ(most.sampleCount(), 32);
    // An error that stays: bias.
    SampleCountSearch biased(samples(), 0.01, SampleCountSearch::Value::Falls);
    run(biased, [](int sampleCount) { return 0.02 + 0.1 / sampleCount; });
    EXPECT_EQ(biased.outcome(), SampleCountSearch::Outcome::MostTooLittle);
}

TEST(SampleCountSearch, NamesTheNeighboursOfTheTarget) {
    const auto time = [](int sampleCount) { return 10.0 * sampleCount; };
    SampleCountSearch between(samples(), 73.0, SampleCountSearch::Value::Rises);
    run(between, time);
    ASSERT_TRUE(between.shortOfTarget() && between.pastTarget());
    EXPECT_EQ(between.shortOfTarget()->sampleCount, 7);
    EXPECT_EQ(between.shortOfTarget()->value, 70.0);
    EXPECT_EQ(between.pastTarget()->sampleCount, 8);
    EXPECT_EQ(between.pastTarget()->value, 80.0);
    SampleCountSearch least(samples(), 5.0, SampleCountSearch::Value::Rises);
    run(least, time);
    EXPECT_FALSE(least.shortOfTarget());
    EXPECT_EQ(least.pastTarget()->sampleCount, 1);
    SampleCountSearch most(samples(), 500.0, SampleCountSearch::Value::Rises);
    run(most, time);
    EXPECT_EQ(most.shortOfTarget()->sampleCount, 32);
    EXPECT_FALSE(most.pastTarget());
}

TEST(SampleCountSearch, AnEndThatIsNearEnoughIsAFind) {
    SampleCountSearch search(samples(), 9.0, SampleCountSearch::Value::Rises);
    run(search, [](int sampleCount) { return 10.0 * sampleCount; });
    EXPECT_EQ(search.outcome(), SampleCountSearch::Outcome::Found);
    EXPECT_EQ(search.sampleCount(), 1);
}

TEST(SampleCountSearch, EndsWhateverIsMeasured) {
    for (const double odd : {0.0, -1.0, 1e300}) {
        SampleCountSearch search(samples(), 1.0, SampleCountSearch::Value::Falls);
        run(search, [&](int) { return odd; });
        EXPECT_NE(search.outcome(), SampleCountSearch::Outcome::Searching);
    }
    SampleCountSearch noisy(samples(), 50.0, SampleCountSearch::Value::Rises);
    run(noisy, [](int sampleCount) { return sampleCount % 2 == 0 ? 100.0 : 1.0; });
    EXPECT_NE(noisy.outcome(), SampleCountSearch::Outcome::Searching);
}

}  // namespace
}  // namespace timeshade
