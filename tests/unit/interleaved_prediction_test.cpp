// What interleaved time-dependent shadow maps must compute, from what the technique states: the numbers of theory.
#include <gtest/gtest.h>

#include "cases/expectation.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

struct Form {
    const char* pattern = "2";
    const char* bias = "2";
    const char* planeTest = "on";
    const char* pcfRadius = "0";
};

double predicted(const std::string& caseName, const Form& form, int strata) {
    gl::ProgramCache programs;
    const std::unique_ptr<Technique> technique = makeTechnique("interleaved", programs);
    setFromText(*technique, "pattern", form.pattern);
    setFromText(*technique, "bias", form.bias);
    setFromText(*technique, "plane_test", form.planeTest);
    setFromText(*technique, "pcf_radius", form.pcfRadius);
    return expectationOf(closedFormCase(caseName), statementOf(*technique), strata, 512).litShare;
}

/// The shadow of case 1 is [.3, .7]: the share of the N P^2 times that lie outside. Half a block of texels, which the
/// caster passes in .0028 P of the shutter, moves each end and may take a time in or out.
TEST(InterleavedPrediction, CountsTheTimesThatAreLit) {
    for (const int strata : {1, 2, 8})
        for (const int side : {1, 2, 3, 4}) {
            const int times = strata * side * side;
            int lit = 0;
            for (int i = 0; i < times; ++i) lit += (i + 0.5) / times < 0.3 || (i + 0.5) / times > 0.7 ? 1 : 0;
            const std::string pattern = std::to_string(side);
            EXPECT_NEAR(predicted("quad_sweeps_point", {.pattern = pattern.c_str()}, strata), double(lit) / times,
                        1.0 / times + 0.0056 * side)
                << strata << " strata, pattern " << side;
        }
}

/// Whatever the bias and the pattern: casters and receiver are seen at the same times.
TEST(InterleavedPrediction, NothingShadowsItself) {
    for (const char* name : {"approaching_self", "cube_top"})
        for (const char* pattern : {"1", "2", "4"})
            for (const char* bias : {"0.05", "2"})
                for (const int strata : {2, 8})
                    EXPECT_EQ(predicted(name, {.pattern = pattern, .bias = bias}, strata), 1.0) << name;
}

TEST(InterleavedPrediction, BiasHidesAContact) {
    EXPECT_EQ(predicted("contact", {}, 8), 1.0);
    EXPECT_EQ(predicted("static_all", {}, 8), 0.0);
}

/// Seen from .3 to .7, all the time in the dark. Its first stratum of eight ends at 3/8 and has the times 17/64, 19/64,
/// 21/64, 23/64: half of them are lit, for .075 of the .4 that it is seen. The last one likewise.
TEST(InterleavedPrediction, AStratumThatIsSeenInPartIsAveragedWhole) {
    EXPECT_NEAR(predicted("visible_only_while_dark", {}, 8), 2.0 * 0.5 * 0.075 / 0.4, 0.005);
}

}  // namespace
}  // namespace timeshade
