// What depth-time ranges must compute, from what the technique states: the numbers of theory.
#include <gtest/gtest.h>

#include "cases/expectation.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

TechniqueStatement ranges(const char* asPublished) {
    gl::ProgramCache programs;
    const std::unique_ptr<Technique> technique = makeTechnique("ranges", programs);
    setFromText(*technique, "as_published", asPublished);
    return statementOf(*technique);
}

double predicted(const char* asPublished, const std::string& caseName) {
    return expectationOf(closedFormCase(caseName), ranges(asPublished), 8, 512).litShare;
}

TEST(RangesPrediction, TheRepairedFormIsRight) {
    for (const char* name :
         {"flip_triangle", "invert_triangle", "ndc_range_lerp", "light_recedes", "quad_sweeps_point"})
        EXPECT_NEAR(predicted("off", name), closedFormCase(name).exact, 0.02) << name;
}

TEST(RangesPrediction, ThePublishedFormFailsByTheseNumbers) {
    // All depths are equal, so the caps make one range: dark all the time.
    EXPECT_NEAR(predicted("on", "flip_triangle"), 0.0, 0.02);
    EXPECT_NEAR(predicted("on", "invert_triangle"), 0.0, 0.02);
    // A translation across the light is right, and so is a light that recedes: vertices are in view space.
    EXPECT_NEAR(predicted("on", "light_recedes"), 2.0 / 3.0, 0.02);
    EXPECT_NEAR(predicted("on", "quad_sweeps_point"), 0.6, 0.02);
    // 1 / distance goes from 1/2 to 1/20, and is 1/11 at u = (1/2 - 1/11) / (1/2 - 1/20) = 1/1.1.
    EXPECT_NEAR(predicted("on", "ndc_range_lerp"), 1.0 - 1.0 / 1.1, 0.01);
    // From 1/1 to 1/9, and 1/6 at u = (1 - 1/6) / (1 - 1/9) = 15/16.
    EXPECT_NEAR(predicted("on", "occluder_passes_receiver"), 1.0 / 16, 0.01);
}

}  // namespace
}  // namespace timeshade
