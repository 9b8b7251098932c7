// The scenes that come with the program: they load without a note, loop and move.

#include <filesystem>

#include <gtest/gtest.h>
#include <timeshade/paths.h>

#include "scene/gltf_scene.h"

namespace timeshade {
namespace {

TEST(SceneAssets, AllLoadAndLoop) {
    const auto folder = std::filesystem::path(TIMESHADE_SOURCE_DIRECTORY) / "assets" / "scenes";
    ASSERT_TRUE(std::filesystem::exists(folder)) << folder << " is not there: the scenes belong to the checkout";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        if (entry.path().extension() != ".glb") continue;
        SCOPED_TRACE(entry.path().filename());
        const auto scene = loadGltf(entry.path());
        for (const std::string& note : scene->notes()) ADD_FAILURE() << "a note: " << note;
        EXPECT_FALSE(scene->cameras().empty());
        ASSERT_GT(scene->duration(), 0.0);
        const SceneDefaults& defaults = scene->defaults();
        const double open = defaults.frame / defaults.framesPerSecond;
        const double close = (defaults.frame + defaults.shutterLength) / defaults.framesPerSecond;
        const MotionMesh mesh = scene->motionMesh(open, close);
        const LightPose from = scene->light(open);
        const LightPose to = scene->light(close);
        EXPECT_TRUE(mesh.positionsOpen != mesh.positionsClose || from.position != to.position);
        // The default frame should not lose more than a percent to straight vertex paths (docs/numerics.md).
        EXPECT_LE(mesh.largestTurnDegrees, 15.0);
        EXPECT_TRUE(scene->loops());
    }
}

}  // namespace
}  // namespace timeshade
