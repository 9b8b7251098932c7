// What deep shadow maps must compute, from what the technique states: the numbers of theory.
#include <gtest/gtest.h>

#include "cases/expectation.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

double predicted(const char* caseName, const char* bias, int strata) {
    gl::ProgramCache programs;
    const std::unique_ptr<Technique> technique = makeTechnique("deep", programs);
    setFromText(*technique, "bias", bias);
    return expectationOf(closedFormCase(caseName), statementOf(*technique), strata, 512).litShare;
}

/// A receiver that approaches the light is behind all that it has yet to become: at u it was nearer during 1 - u, half
/// of the shutter in the mean, whatever the samples. A bias of b texels takes away what it hides; at 8 units a shutter
/// and a texel of 9 to 1 times 2 tan(.62) / 512, 0.5 texels hide less than 1/500 of it.
TEST(DeepPrediction, AnApproachingReceiverShadowsItselfForHalfOfTheShutter) {
    for (const int strata : {2, 8, 32}) EXPECT_NEAR(predicted("approaching_self", "0.5", strata), 0.5, 0.005);
    EXPECT_GT(predicted("approaching_self", "64", 8), 0.55);
}

/// A still receiver sees the true mean; one that is seen only while it is dark sees the same mean, and is wrong.
TEST(DeepPrediction, KnowsNoTime) {
    EXPECT_NEAR(predicted("quad_sweeps_point", "0.5", 8), 0.6, 0.01);
    EXPECT_NEAR(predicted("visible_only_while_dark", "0.5", 8), 0.6, 0.01);
}

/// A caster passes the receiver's depth while it covers it: the mean over the shutter at a depth.
TEST(DeepPrediction, DependsOnTheDepth) {
    EXPECT_NEAR(predicted("occluder_passes_receiver", "0.5", 8), 0.375, 0.01);
    EXPECT_NEAR(predicted("receiver_passes_occluder", "0.5", 8), 0.375, 0.01);
}

}  // namespace
}  // namespace timeshade
