// What time-dependent shadow maps must compute, from what the technique states: the numbers of theory.
#include <gtest/gtest.h>

#include "cases/expectation.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

double predicted(const char* dynamicBias, const char* bias, int strata) {
    gl::ProgramCache programs;
    const std::unique_ptr<Technique> technique = makeTechnique("tsm", programs);
    setFromText(*technique, "dynamic_bias", dynamicBias);
    setFromText(*technique, "bias", bias);
    return expectationOf(closedFormCase("approaching_self"), statementOf(*technique), strata, 512).litShare;
}

/// 1/2 (1 - b N / v)^2 of the samples are in the receiver's own shadow: half of them without a bias, whatever N, but
/// for the sixteenth of the grid's pairs that are equal times.
TEST(TsmPrediction, SelfShadowDependsOnTheBias) {
    for (const int strata : {2, 8, 32}) EXPECT_NEAR(predicted("off", "0", strata), 0.5, 0.5 / 16 + 0.01);
    EXPECT_GT(predicted("off", "32", 8), 0.6);
}

TEST(TsmPrediction, ThePlaneTestEndsTheSelfShadow) {
    gl::ProgramCache programs;
    const std::unique_ptr<Technique> technique = makeTechnique("tsm", programs);
    setFromText(*technique, "plane_test", "on");
    const auto lit = [&](const char* name) {
        return expectationOf(closedFormCase(name), statementOf(*technique), 8, 512).litShare;
    };
    EXPECT_EQ(lit("approaching_self"), 1.0);
    // And a real shadow stays: its ends are a random time of their stratum apart.
    EXPECT_NEAR(lit("quad_sweeps_point"), 0.6, 0.02);
    EXPECT_EQ(lit("static_all"), 0.0);
}

TEST(TsmPrediction, TheDynamicBiasEndsTheSelfShadow) {
    for (const char* form : {"both_times", "eq12"}) {
        EXPECT_NEAR(predicted(form, "0", 8), 1.0, 1e-9) << form;
        EXPECT_NEAR(predicted(form, "0.5", 2), 1.0, 1e-9) << form;
    }
}

}  // namespace
}  // namespace timeshade
