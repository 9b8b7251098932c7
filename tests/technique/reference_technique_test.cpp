// The reference technique: the oracle's lit values by way of the frame function, and what is made of them.

#include <cmath>
#include <filesystem>

#include <unistd.h>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "measure/case_matrix.h"
#include "measure/display_encoding.h"
#include "measure/embree_baseline.h"
#include "measure/reference.h"
#include "measure/reference_technique.h"
#include "measure/verification.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

FramePlan planOf(Scene& scene, int samplesPerPixel) {
    FramePlanner planner(scene);
    return planner.plan(ProceduralScene::request(16, 128, samplesPerPixel, 256, 5));
}

/// No map, no bias: only the sampling of time is left. Each end of a shadow splits one stratum of each pixel.
TEST(Truth, HasTheExactLitShareOfEveryCase) {
    for (const ClosedFormCase& c : closedFormCases()) {
        if (c.kind != ClosedFormCase::Kind::Picture) continue;
        ReferenceTechnique truth;
        const CaseResult r = runCase(sharedRenderer(), truth, c, {16, 256});
        EXPECT_EQ(r.verdict, Verdict::Right)
            << c.name << ": " << r.value << " instead of " << r.exact << ", tolerance " << r.tolerance;
        EXPECT_LT(r.tolerance, c.fleeting ? 0.1 : 0.02) << c.name;
    }
}

TEST(Truth, VerifiesAsRight) {
    ReferenceTechnique truth;
    const Verification v = verifyFrame(sharedRenderer(), planOf(*closedFormCase("light_slides").scene, 8), truth, {});
    EXPECT_EQ(v.samples, 16u * 128u * 8u);
    EXPECT_GT(v.tested, 16000u);
    EXPECT_GT(v.shadowed, 3000u);
    EXPECT_EQ(v.disagree(), 0u);
    EXPECT_EQ(v.primaryDisagree, 0u);
    EXPECT_EQ(v.meanAbsoluteError, 0.0);
}

/// Half of the samples of a receiver that approaches the light are false shadow for tsm, and verify says just that.
TEST(Verification, CountsThePredictedSelfShadow) {
    const std::unique_ptr<Technique> tsm = makeTechnique("tsm", sharedRenderer().programs());
    setFromText(*tsm, "bias", "0");
    const Verification v =
        verifyFrame(sharedRenderer(), planOf(*closedFormCase("approaching_self").scene, 8), *tsm, {});
    EXPECT_EQ(v.falseLit, 0u);
    EXPECT_EQ(v.shadowed, 0u);
    EXPECT_NEAR(v.ppm(), 500000.0, 40000.0);
}

TEST(Reference, ComesOutOfTheCacheAsItWentIn) {
    const std::filesystem::path folder =
        std::filesystem::temp_directory_path() / ("timeshade-reference-" + std::to_string(getpid()));
    ReferenceCache cache(folder);
    const FramePlan plan = planOf(*closedFormCase("quad_sweeps_point").scene, 4);
    ReferenceOptions options;
    options.samplesPerPixel = 64;
    int batches = 0;
    options.progress = [&](int, int) { ++batches; };
    const LinearImage drawn = referenceImage(sharedRenderer(), plan, options, cache);
    EXPECT_EQ(batches, 2);
    const LinearImage cached = referenceImage(sharedRenderer(), plan, options, cache);
    EXPECT_EQ(batches, 2) << "drawn again";
    EXPECT_EQ(drawn.rgb, cached.rgb);
    // What the image under test may choose is not part of the key; what it shows is.
    EXPECT_EQ(referenceKey(plan, options),
              referenceKey(planOf(*closedFormCase("quad_sweeps_point").scene, 8), options));
    EXPECT_NE(referenceKey(plan, options), referenceKey(planOf(*closedFormCase("quad_enters").scene, 4), options));
    std::filesystem::remove_all(folder);
}

TEST(DisplayEncoding, IsWhatTheDisplayPassShows) {
    ReferenceTechnique truth;
    sharedRenderer().draw(planOf(*closedFormCase("light_slides").scene, 8), truth, View::Final);
    const DisplayImage shown = sharedRenderer().readPicture();
    const DisplayImage encoded = displayed(sharedRenderer().readRadiance(), true);
    ASSERT_EQ(shown.rgb.size(), encoded.rgb.size());
    // One level: the GPU's pow is not the library's.
    for (std::size_t i = 0; i < shown.rgb.size(); ++i) ASSERT_NEAR(shown.rgb[i], encoded.rgb[i], 1) << "value " << i;
}

/// The Embree baseline is only timed, but it must do the same work.
TEST(EmbreeBaseline, SeesWhatTheSamplePassSees) {
    const FramePlan plan = planOf(*closedFormCase("light_slides").scene, 8);
    ReferenceTechnique truth;
    sharedRenderer().draw(plan, truth, View::Visibility);
    EmbreeBaseline baseline(plan);
    baseline.build();
    EXPECT_EQ(baseline.tracePrimaries(), sharedRenderer().readSampleIds());
    const double dark = static_cast<double>(baseline.traceShadows()) / (16.0 * 128.0 * 8.0);
    EXPECT_NEAR(dark, 0.25, 0.02);
}

}  // namespace

}  // namespace timeshade
