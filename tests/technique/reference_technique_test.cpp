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

/// A still camera keeps the samples of what stands still from frame to frame; those of a reference are its own.
TEST(Reference, UsesNoSamplesThatAFrameHasKept) {
    ProceduralScene scene;
    for (int x = -4; x < 4; ++x)
        for (int y = -4; y < 4; ++y) {  // at two heights, so that a sample of one is nowhere near the other's
            const glm::dvec3 centre(x + 0.5, y + 0.5, (x + y) % 2 == 0 ? 0.0 : 0.3);
            scene.quads.push_back(slidingQuad(centre, centre, 0.5, -0.5, 0.5));
        }
    scene.quads.push_back(slidingQuad({-1, 0, 1}, {1, 0, 1}, 0.5, -0.5, 0.5));
    scene.lightOpen.position = {0, 0, 10};
    scene.lightClose = scene.lightOpen;
    scene.cameraOpen = scene.cameraClose = lookAt({2, -9, 7}, {0, 0, 0}, {0, 0, 1}, 0.7, 0.01);
    scene.finish();
    const auto reference = [&](bool useCaches) {
        FrameRenderer& renderer = sharedRenderer();
        FramePlanner planner(scene);
        FrameRequest request = ProceduralScene::request(32, 24, 4, 64, 5);
        request.useCaches = useCaches;
        const FramePlan plan = planner.plan(request);
        EXPECT_EQ(plan.versions.samples != 0, useCaches);
        const std::unique_ptr<Technique> technique =
            makeTechnique(techniqueDescriptions().front().name, renderer.programs());
        for (int again = 0; again < 3; ++again) renderer.draw(plan, *technique, View::Final);
        ReferenceOptions options;
        options.samplesPerPixel = 160;  // batches enough for one to be drawn onto what another has kept
        ReferenceCache nothingKept{std::filesystem::path()};
        return referenceImage(renderer, plan, options, nothingKept);
    };
    EXPECT_TRUE(reference(true).rgb == reference(false).rgb);
}

TEST(DisplayEncoding, IsWhatTheDisplayPassShows) {
    ReferenceTechnique truth;
    FramePlan plan = planOf(*closedFormCase("light_slides").scene, 8);
    std::vector<std::uint8_t> before;
    for (const DisplayLook& look :
         {DisplayLook{}, DisplayLook{-1.5}, DisplayLook{0.0, ToneMap::Reinhard}, DisplayLook{-1.0, ToneMap::Linear}}) {
        plan.request.look = look;
        sharedRenderer().draw(plan, truth, View::Final);
        const DisplayImage shown = sharedRenderer().readPicture();
        const DisplayImage encoded = displayed(sharedRenderer().readRadiance(), look);
        ASSERT_EQ(shown.rgb.size(), encoded.rgb.size());
        // One level: the GPU's pow is not the library's.
        for (std::size_t i = 0; i < shown.rgb.size(); ++i)
            ASSERT_NEAR(shown.rgb[i], encoded.rgb[i], 1) << "value " << i;
        EXPECT_NE(shown.rgb, before);
        before = shown.rgb;
    }
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
