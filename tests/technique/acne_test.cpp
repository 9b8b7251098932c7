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
    double ofAll = 0.0, ofStone = 0.0;  ///< of a million tested samples, and of a million of those on the stone
};

FalseShadows falseShadows(const std::string& technique, const std::string& setting) {
    static const std::unique_ptr<Scene> sphere = openScene("sphere", "");
    FrameRequest request;
    request.width = 240;
    request.height = 180;
    request.samplesPerPixel = 8;
    request.mapSize = 512;
    request.frame = sphere->defaults().frame;
    request.shutter = {sphere->defaults().framesPerSecond, sphere->defaults().shutterLength, ShutterPosition::Start};
    const std::unique_ptr<Technique> drawn = makeTechnique(technique, sharedRenderer().programs());
    if (!setting.empty()) setFromText(*drawn, setting, "on");
    const FramePlan plan = FramePlanner(*sphere).plan(request);
    double onStone = 0.0, dark = 0.0;
    VerificationOptions options;
    options.visit = [&](const VerifiedSample& sample) {
        if (sample.triangle == NO_TRIANGLE || !sample.truth.tested ||
            plan.mesh->topology->triangleInstances[sample.triangle] == 0)
            return;
        onStone += 1.0;
        dark += sample.truth.lit && sample.lit < 0.5f ? 1.0 : 0.0;
    };
    const Verification v = verifyFrame(sharedRenderer(), plan, *drawn, options);
    EXPECT_GT(onStone, 5000.0);
    return {1e6 * static_cast<double>(v.falseShadow) / static_cast<double>(v.tested), 1e6 * dark / onStone};
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

/// Without it there is acne.
TEST(Acne, IsThereWithoutTheDynamicBias) { EXPECT_GT(falseShadows("tsm", "").ofStone, 5000.0); }

}  // namespace
}  // namespace timeshade
