// A map that is fitted to what the camera sees has finer texels there: fewer samples are wrong.
#include <gtest/gtest.h>

#include "measure/verification.h"
#include "scenes/scene_recipe.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

FrameRequest requestOf(const Scene& scene) {
    FrameRequest request;
    request.width = 160;
    request.height = 120;
    request.samplesPerPixel = 4;
    request.mapSize = 256;
    request.shutter = {scene.defaults().framesPerSecond, scene.defaults().shutterLength, ShutterPosition::Start};
    return request;
}

double wrongPpm(const FramePlan& plan, const char* fit) {
    const std::unique_ptr<Technique> technique = makeTechnique("static", sharedRenderer().programs());
    setFromText(*technique, "fit", fit);
    const Verification v = verifyFrame(sharedRenderer(), plan, *technique, {});
    EXPECT_GT(v.tested, 10000u);
    return 1e6 * static_cast<double>(v.falseShadow + v.falseLit) / static_cast<double>(v.tested);
}

/// Some shadows of many, from near, of a moment.
TEST(StaticFit, FinerTexelsAreLessWrong) {
    const std::unique_ptr<Scene> scene = makeRecipe("cubes")->make();
    FrameRequest request = requestOf(*scene);
    request.shutter.length = 0.0;
    request.cameraPose = lookAt({6.0, 3.0, 8.0}, {3.0, 0.0, 2.0}, {0.0, 1.0, 0.0}, 0.5, 0.01);
    const FramePlan plan = FramePlanner(*scene).plan(request);
    const double whole = wrongPpm(plan, "whole-light");
    EXPECT_GT(whole, 20000.0);
    EXPECT_LT(wrongPpm(plan, "camera-view"), 0.5 * whole);
    EXPECT_LT(wrongPpm(plan, "lispsm"), 0.85 * whole);
}

/// What is fitted covers all that the camera sees on its way: else shadows there would be lost.
TEST(StaticFit, HoldsWhileTheCameraMoves) {
    const std::unique_ptr<Scene> scene = makeRecipe("frusta")->make();
    FrameRequest request = requestOf(*scene);
    while (scene->cameras()[request.cameraIndex].name != "path") ++request.cameraIndex;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    ASSERT_TRUE(plan.motion.cameraMoves);
    const double whole = wrongPpm(plan, "whole-light");
    for (const char* fit : {"camera-view", "lispsm"}) EXPECT_LT(wrongPpm(plan, fit), 1.1 * whole) << fit;
}

}  // namespace
}  // namespace timeshade
