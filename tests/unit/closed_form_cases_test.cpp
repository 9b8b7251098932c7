// The analytic cases themselves: their exact lit shares against numerical integration in double precision.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "cases/closed_form_cases.h"
#include "cases/expectation.h"
#include "core/error.h"

namespace timeshade {
namespace {

TEST(ClosedFormCases, AllRowsAreThere) {
    std::set<int> rows;
    std::set<std::string> names;
    for (const ClosedFormCase& c : closedFormCases()) {
        EXPECT_TRUE(rows.insert(c.row).second) << c.row;
        EXPECT_TRUE(names.insert(c.name).second) << c.name;
        EXPECT_EQ(c.kind == ClosedFormCase::Kind::Picture, c.scene != nullptr) << c.name;
        EXPECT_EQ(c.kind == ClosedFormCase::Kind::Numeric, c.evaluate != nullptr) << c.name;
        EXPECT_FALSE(c.motion.empty() || c.breaks.empty()) << c.name;
    }
    EXPECT_EQ(rows.size(), 35u);
    EXPECT_EQ(*rows.rbegin(), 35);
    EXPECT_THROW(closedFormCase("no such"), UsageError);
}

TEST(ClosedFormCases, ExactSharesAreThoseOfBruteIntegration) {
    for (const ClosedFormCase& c : closedFormCases()) {
        if (c.kind != ClosedFormCase::Kind::Picture) continue;
        const Expectation e = expectationOf(c, SamplingTraits{}, 32, 512);
        // Midpoints of 1536 steps: each end is off by half a step at most; slivers and bullets slip through.
        const double allowed =
            c.fleeting ? (c.name == "many_slivers" ? 0.02 : 6e-4) : 1e-5 + c.ends * 0.5 / 1536.0 + 0.2 * c.patchWidth;
        EXPECT_NEAR(e.litShare, c.exact, allowed) << c.name;
    }
}

TEST(ClosedFormCases, NumericOnesAreExact) {
    for (const ClosedFormCase& c : closedFormCases())
        if (c.kind == ClosedFormCase::Kind::Numeric) {
            EXPECT_NEAR(c.evaluate(), c.exact, 1e-6) << c.name;
        }
}

/// What theory predicts for a technique that tests at another time than the sample's, from its traits alone.
TEST(Expectation, HasTheNumbersOfTheory) {
    SamplingTraits oneInstant;
    oneInstant.times = SamplingTraits::Times::OneInstant;
    oneInstant.texelCentres = true;
    EXPECT_EQ(expectationOf(closedFormCase("quad_sweeps_point"), oneInstant, 8, 512).litShare, 0.0);
    EXPECT_NEAR(expectationOf(closedFormCase("quad_enters"), oneInstant, 8, 512).litShare, 1.0, 1e-9);
    EXPECT_NEAR(expectationOf(closedFormCase("subtexel_static"), oneInstant, 8, 512).litShare, 1.0, 1e-9);

    SamplingTraits random;
    random.times = SamplingTraits::Times::RandomInStratum;
    random.texelCentres = true;
    // 1/2 (1 - b N / v)^2 without a bias, whatever N; a sixteenth of the grid's pairs are equal times.
    for (const int strata : {2, 8, 32})
        EXPECT_NEAR(expectationOf(closedFormCase("approaching_self"), random, strata, 512).litShare, 0.5,
                    0.5 / 16 + 0.01);
    random.movesDepth = true;
    EXPECT_NEAR(expectationOf(closedFormCase("approaching_self"), random, 8, 512).litShare, 1.0, 1e-9);

    SamplingTraits ranges;
    ranges.texelCentres = ranges.firstAndLast = true;
    EXPECT_NEAR(expectationOf(closedFormCase("flip_triangle"), ranges, 8, 512).litShare, 0.0, 0.02);
    EXPECT_NEAR(expectationOf(closedFormCase("invert_triangle"), ranges, 8, 512).litShare, 0.0, 0.02);
    EXPECT_NEAR(expectationOf(closedFormCase("quad_sweeps_point"), ranges, 8, 512).litShare, 0.6, 0.02);
}

}  // namespace
}  // namespace timeshade
