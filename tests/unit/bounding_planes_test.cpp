// Triangles in a side of the scene's box that faces the light cannot cast shadows; those elsewhere may.
#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "culling/bounding_planes.h"
#include "plan/frame_plan.h"

namespace timeshade {
namespace {

class BoundingPlanesTest : public testing::Test {
  protected:
    BoundingPlanesTest() {
        scene_.lightOpen.position = {0.0, 0.0, 10.0};  // axes: identity, so that it shines along -z
        scene_.lightOpen.outerConeAngle = 0.6;
        scene_.lightClose = scene_.lightOpen;
        scene_.cameraOpen.eye = scene_.cameraClose.eye = {0.0, 0.0, 20.0};
        add(0.0, 0.0);  // the ground: triangles 0 and 1
    }

    void add(double from, double to) { scene_.quads.push_back(slidingQuad({0, 0, from}, {1, 0, to}, 2.0, -2.0, 2.0)); }

    bool groundIsABoundingPlane() {
        scene_.finish();
        const FramePlan plan = FramePlanner(scene_).plan(ProceduralScene::request(16, 16, 2, 64, 1));
        const BoundingPlanes boundingPlanes(plan.extent, plan.block, plan.light);
        const bool held = boundingPlanes.holds(plan.texels->positions, 0);
        EXPECT_EQ(boundingPlanes.holds(plan.texels->positions, 1), held);
        for (std::uint32_t id = 2; id < plan.triangles->size(); ++id)
            EXPECT_FALSE(boundingPlanes.holds(plan.texels->positions, id) && scene_.quads[id / 2].close[0].z > 0.0);
        return held;
    }

    ProceduralScene scene_;
};

TEST_F(BoundingPlanesTest, IsTheGroundBelowEverything) {
    add(2.0, 3.0);
    add(6.0, 6.0);
    EXPECT_TRUE(groundIsABoundingPlane());  // and it slides, which does not matter
}

TEST_F(BoundingPlanesTest, HasNothingBehindIt) {
    add(-1e-3, 5.0);  // comes from below
    EXPECT_FALSE(groundIsABoundingPlane());
}

TEST_F(BoundingPlanesTest, AllowsForNothing) {
    add(1e-6, 5.0);
    EXPECT_TRUE(groundIsABoundingPlane());
    add(-1e-6, 5.0);  // a receiver, however little it lies behind
    EXPECT_FALSE(groundIsABoundingPlane());
}

TEST_F(BoundingPlanesTest, IsNoneToALightBehindIt) {
    add(2.0, 3.0);
    scene_.lightClose.position.z = -1.0;
    EXPECT_FALSE(groundIsABoundingPlane());
}

TEST_F(BoundingPlanesTest, IsOneToALightThatGrazesIt) {
    add(2.0, 3.0);
    scene_.lightOpen.position.z = scene_.lightClose.position.z = 1e-2;
    EXPECT_TRUE(groundIsABoundingPlane());
}

TEST_F(BoundingPlanesTest, IsThereForADirectionalLight) {
    add(2.0, 3.0);
    scene_.lightOpen.kind = scene_.lightClose.kind = LightKind::Directional;
    EXPECT_TRUE(groundIsABoundingPlane());
}

TEST_F(BoundingPlanesTest, IsNoneWhereItRisesInTheShutter) {
    scene_.quads.front() = slidingQuad({0, 0, 0}, {0, 0, 1}, 2.0, -2.0, 2.0);
    add(0.0, 0.0);  // stays, and is behind it
    EXPECT_FALSE(groundIsABoundingPlane());
}

}  // namespace
}  // namespace timeshade
