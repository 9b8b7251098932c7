// A convex closed body that moves and rotates under the light does not shadow its own lit side: every false shadow on
// it is self-shadowing (acne).
#include <gtest/gtest.h>

#include "measure/verification.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

struct FalseShadows {
    double ofAll = 0.0, ofStone = 0.0;  ///< of a million tested samples; light that a million on the stone lack
};

FalseShadows falseShadows(const std::string& technique, const std::string& setting, int samplesPerPixel = 8) {
    static const std::unique_ptr<Scene> sphere = openScene("sphere", "");
    FrameRequest request;
    request.width = 240;
    request.height = 180;
    request.samplesPerPixel = samplesPerPixel;
    request.mapSize = 512;
    request.frame = sphere->defaults().frame;
    request.shutter = {sphere->defaults().framesPerSecond, sphere->defaults().shutterLength, ShutterPosition::Start};
    const std::unique_ptr<Technique> drawn = makeTechnique(technique, sharedRenderer().programs());
    if (!setting.empty()) setFromText(*drawn, setting, "on");
    const FramePlan plan = FramePlanner(*sphere).plan(request);
    double onStone = 0.0, missing = 0.0;
    VerificationOptions options;
    options.visit = [&](const VerifiedSample& sample) {
        if (sample.triangle == NO_TRIANGLE || !sample.truth.tested ||
            plan.mesh->topology->triangleInstances[sample.triangle] == 0)
            return;
        onStone += 1.0;
        missing += sample.truth.lit ? 1.0 - static_cast<double>(sample.lit) : 0.0;
    };
    const Verification v = verifyFrame(sharedRenderer(), plan, *drawn, options);
    EXPECT_GT(onStone, 600.0 * samplesPerPixel);
    return {1e6 * static_cast<double>(v.falseShadow) / static_cast<double>(v.tested), 1e6 * missing / onStone};
}

/// At default bias. Errors that remain are at the edges of the shadow on the ground, early or late by a part of a
/// stratum.
TEST(Acne, IsNoneOnASphereThatTurns) {
    const FalseShadows tsm = falseShadows("tsm", "dynamic_bias");
    EXPECT_LT(tsm.ofAll, 1000.0);
    EXPECT_LT(tsm.ofStone, 100.0);
    for (const char* repaired : {"ranges", "temporal"}) {
        const FalseShadows prisms = falseShadows(repaired, "");
        EXPECT_LT(prisms.ofAll, 1000.0) << repaired;
        EXPECT_LT(prisms.ofStone, 100.0) << repaired;
    }
}

/// The plane of the receiver's own triangle instead: a sphere falls away from it.
TEST(Acne, IsNoneWhereThePlaneIsTested) {
    EXPECT_LT(falseShadows("tsm", "plane_test").ofStone, 100.0);
    EXPECT_LT(falseShadows("interleaved", "").ofStone, 100.0);
}

/// One stratum for the whole shutter: where the stone turns away from the light within it, what is looked at then, from
/// behind, is no part of what is seen before.
TEST(Acne, IsNoneWhereASurfaceTurnsAwayWithinAStratum) { EXPECT_LT(falseShadows("interleaved", "", 1).ofStone, 100.0); }

/// Without it there is acne.
TEST(Acne, IsThereWithoutTheDynamicBias) { EXPECT_GT(falseShadows("tsm", "").ofStone, 5000.0); }

}  // namespace
}  // namespace timeshade
