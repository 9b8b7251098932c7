// The search for an equal: right effort, few measurements, and a plain word where there is none.
#include <gtest/gtest.h>

#include <functional>
#include <numeric>

#include "measure/effort_search.h"

namespace timeshade {
namespace {

std::vector<int> samples() {
    std::vector<int> efforts(32);
    std::iota(efforts.begin(), efforts.end(), 1);
    return efforts;
}

/// Runs the search to its end; how many measurements it took.
int run(EffortSearch& search, const std::function<double(int)>& value) {
    int measurements = 0;
    while (const auto effort = search.next()) {
        search.answer(value(*effort));
        if (++measurements > 100) ADD_FAILURE() << "the search does not end";
        if (measurements > 100) break;
    }
    return measurements;
}

TEST(EffortSearch, FindsEveryEffort) {
    for (int wanted = 1; wanted <= 32; ++wanted) {
        EffortSearch time(samples(), 10.0 + 3.0 * wanted, EffortSearch::Value::Rises);
        EXPECT_LE(run(time, [](int effort) { return 10.0 + 3.0 * effort; }), 10);
        EXPECT_EQ(time.outcome(), EffortSearch::Outcome::Found);
        EXPECT_EQ(time.effort(), wanted);
        EffortSearch error(samples(), 1.0 / wanted, EffortSearch::Value::Falls);
        EXPECT_LE(run(error, [](int effort) { return 1.0 / effort; }), 10);
        EXPECT_EQ(error.effort(), wanted);
        EXPECT_DOUBLE_EQ(error.value(), 1.0 / wanted);
    }
}

TEST(EffortSearch, TakesTheNearerNeighbourByRatio) {
    // 28.4 lies above the geometric mean of 20 and 40, and below the arithmetic one.
    EffortSearch search({1, 2, 4, 8}, 28.4, EffortSearch::Value::Rises);
    run(search, [](int effort) { return 10.0 * effort; });
    EXPECT_EQ(search.outcome(), EffortSearch::Outcome::Found);
    EXPECT_EQ(search.effort(), 4);
}

TEST(EffortSearch, SaysWhereTheTargetIsOutOfRange) {
    const auto time = [](int effort) { return 10.0 * effort; };
    EffortSearch least(samples(), 5.0, EffortSearch::Value::Rises);
    EXPECT_EQ(run(least, time), 1);
    EXPECT_EQ(least.outcome(), EffortSearch::Outcome::LeastTooMuch);
    EXPECT_EQ(least.effort(), 1);
    EffortSearch most(samples(), 500.0, EffortSearch::Value::Rises);
    EXPECT_EQ(run(most, time), 6);
    EXPECT_EQ(most.outcome(), EffortSearch::Outcome::MostTooLittle);
    EXPECT_EQ(most.effort(), 32);
    // An error that stays: bias.
    EffortSearch biased(samples(), 0.01, EffortSearch::Value::Falls);
    run(biased, [](int effort) { return 0.02 + 0.1 / effort; });
    EXPECT_EQ(biased.outcome(), EffortSearch::Outcome::MostTooLittle);
}

TEST(EffortSearch, AnEndThatIsNearEnoughIsAFind) {
    EffortSearch search(samples(), 9.0, EffortSearch::Value::Rises);
    run(search, [](int effort) { return 10.0 * effort; });
    EXPECT_EQ(search.outcome(), EffortSearch::Outcome::Found);
    EXPECT_EQ(search.effort(), 1);
}

TEST(EffortSearch, EndsWhateverIsMeasured) {
    for (const double odd : {0.0, -1.0, 1e300}) {
        EffortSearch search(samples(), 1.0, EffortSearch::Value::Falls);
        run(search, [&](int) { return odd; });
        EXPECT_NE(search.outcome(), EffortSearch::Outcome::Searching);
    }
    EffortSearch noisy(samples(), 50.0, EffortSearch::Value::Rises);
    run(noisy, [](int effort) { return effort % 2 == 0 ? 100.0 : 1.0; });
    EXPECT_NE(noisy.outcome(), EffortSearch::Outcome::Searching);
}

} // namespace
} // namespace timeshade
