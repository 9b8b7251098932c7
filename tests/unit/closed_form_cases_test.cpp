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
        const Expectation e = expectationOf(c, TechniqueStatement{}, 32, 512);
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
    TechniqueStatement oneInstant;
    oneInstant.traits.times = SamplingTraits::Times::OneInstant;
    oneInstant.traits.texelCentres = true;
    EXPECT_EQ(expectationOf(closedFormCase("quad_sweeps_point"), oneInstant, 8, 512).litShare, 0.0);
    EXPECT_NEAR(expectationOf(closedFormCase("quad_enters"), oneInstant, 8, 512).litShare, 1.0, 1e-9);
    EXPECT_NEAR(expectationOf(closedFormCase("subtexel_static"), oneInstant, 8, 512).litShare, 1.0, 1e-9);
    // In many renders, each of its own instant, nothing but the map's resolution is left.
    oneInstant.renders = 64;
    EXPECT_NEAR(expectationOf(closedFormCase("quad_sweeps_point"), oneInstant, 8, 512).litShare, 0.6, 1.0 / 64);

    TechniqueStatement random;
    random.traits.times = SamplingTraits::Times::RandomInStratum;
    random.traits.texelCentres = true;
    // 1/2 (1 - b N / v)^2 without a bias, whatever N; a sixteenth of the grid's pairs are equal times.
    for (const int strata : {2, 8, 32})
        EXPECT_NEAR(expectationOf(closedFormCase("approaching_self"), random, strata, 512).litShare, 0.5,
                    0.5 / 16 + 0.01);
}

/// A value that is the mean over a longer time knows nothing of when the receiver is seen.
TEST(Expectation, FollowsTheFootprint) {
    const ClosedFormCase& c = closedFormCase("visible_only_while_dark");
    TechniqueStatement stated;
    EXPECT_EQ(expectationOf(c, stated, 8, 512).litShare, 0.0);
    stated.footprint.time = Footprint::Time::Shutter;
    EXPECT_NEAR(expectationOf(c, stated, 8, 512).litShare, 0.6, 0.01);
    // Of eight strata two are cut by the shadow's ends at .3 and .7: [.25, .375] is lit for 40 %, and so is its mirror.
    stated.footprint.time = Footprint::Time::Stratum;
    const double cut = 0.4 * 0.075, seen = 0.4;
    EXPECT_NEAR(expectationOf(c, stated, 8, 512).litShare, 2.0 * cut / seen, 0.01);
    // At u = 1/2 the shadow ends 0.25 beside the receiver. A texel is 0.22 wide, and the receiver lies where two meet:
    // of the three columns of tests around one of them, one is in the shadow.
    ClosedFormCase beside = closedFormCase("quad_enters");
    beside.patchHeight = 0.01;
    stated = {};
    stated.traits = {.times = SamplingTraits::Times::OneInstant, .texelCentres = true};
    EXPECT_EQ(expectationOf(beside, stated, 8, 64).litShare, 1.0);
    stated.footprint.filterTexels = 3.0;
    EXPECT_NEAR(expectationOf(beside, stated, 8, 64).litShare, 5.0 / 6.0, 1e-9);
}

/// Two layers of the map, a caster in each, whose visibilities over the shutter are multiplied.
class ProductOfLayers final : public Prediction {
  public:
    std::optional<double> lit(const ReceiverInMap& receiver, double u) const override {
        const glm::dvec3 p = receiver.path.at(u);
        double lit = 1.0;
        for (std::size_t quad = 0; quad < 2; ++quad) {
            constexpr int steps = 200;
            int free = 0;
            for (int k = 0; k < steps; ++k) {
                const double v = (k + 0.5) / steps;
                free += casterDistance(receiver, 2 * quad, glm::dvec2(p) / p.z, u, v) ||
                                casterDistance(receiver, 2 * quad + 1, glm::dvec2(p) / p.z, u, v)
                            ? 0
                            : 1;
            }
            lit *= double(free) / steps;
        }
        return lit;
    }
};

TEST(Expectation, TakesATechniquesOwnValue) {
    TechniqueStatement stated;
    stated.footprint.time = Footprint::Time::Shutter;
    stated.traits.texelCentres = true;
    stated.prediction = std::make_shared<ProductOfLayers>();
    EXPECT_NEAR(expectationOf(closedFormCase("two_disjoint"), stated, 2, 512).litShare, 0.64, 0.01);
    EXPECT_NEAR(expectationOf(closedFormCase("two_overlap"), stated, 2, 512).litShare, 0.64, 0.01);
}

}  // namespace
}  // namespace timeshade
