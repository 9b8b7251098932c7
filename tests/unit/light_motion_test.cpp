// Which triangles move in the light's own frame: techniques that store times for dynamic triangles only rely on it.
#include <gtest/gtest.h>

#include "cases/procedural_scene.h"
#include "plan/frame_plan.h"

namespace timeshade {
namespace {

using Ids = std::vector<std::uint32_t>;

class LightMotionTest : public testing::Test {
  protected:
    LightMotionTest() {
        scene_.lightOpen.position = {0.0, 0.0, 10.0};  // axes: identity, so that it shines along -z
        scene_.lightOpen.outerConeAngle = 0.6;
        scene_.lightClose = scene_.lightOpen;
        scene_.cameraOpen.eye = scene_.cameraClose.eye = {0.0, 0.0, 20.0};
    }

    void add(glm::dvec3 from, glm::dvec3 to) { scene_.quads.push_back(slidingQuad(from, to, 0.5, -0.5, 0.5)); }

    LightMotion classify() {
        scene_.finish();
        return FramePlanner(scene_).plan(ProceduralScene::request(16, 16, 2, 64, 1)).casters;
    }

    ProceduralScene scene_;
};

TEST_F(LightMotionTest, SplitsStaticFromDynamicAndDropsWhatIsOutside) {
    add({0, 0, 0}, {0, 0, 0});       // 0, 1: static
    add({0, 0, 5}, {0.25, 0, 5});    // 2, 3: moves
    add({40, 0, 0}, {40, 0, 0});     // 4, 5: outside
    add({40, 0, 5}, {50, 0, 5});     // 6, 7: outside throughout
    add({-40, 0, 5}, {40, 0, 5});    // 8, 9: passes through
    add({0, 0, 5}, {0, 0, 5.0001});  // 10, 11: moves hardly, but moves
    const LightMotion motion = classify();
    EXPECT_EQ(motion.staticCasters, (Ids{0, 1}));
    EXPECT_EQ(motion.dynamicCasters, (Ids{2, 3, 8, 9, 10, 11}));
    EXPECT_TRUE(motion.nearPlane.empty());
    EXPECT_EQ(motion.nonTranslating, 0u);
}

TEST_F(LightMotionTest, UsesTheFrameOfAMovingLight) {
    scene_.lightClose.position = {1.0, 0.0, 10.0};
    add({0, 0, 0}, {0, 0, 0});  // 0, 1: static in the world, dynamic in the map
    add({0, 0, 5}, {1, 0, 5});  // 2, 3: moves with the light, which leaves at most rounding
    const LightMotion motion = classify();
    EXPECT_EQ(motion.staticCasters.size() + motion.dynamicCasters.size(), 4u);
    EXPECT_GE(motion.dynamicCasters.size(), 2u);
    EXPECT_EQ(motion.dynamicCasters[0], 0u);
    EXPECT_EQ(motion.dynamicCasters[1], 1u);
    EXPECT_EQ(motion.nonTranslating, 0u);
}

TEST_F(LightMotionTest, FindsWhatCrossesTheNearPlane) {
    add({0, 0, 9}, {0, 0, 11});   // 0, 1: past the light
    add({0, 0, 9}, {0, 0, 9.5});  // 2, 3: nearer, but in front
    add({0, 0, 11}, {0, 0, 12});  // 4, 5: behind the light throughout
    const LightMotion motion = classify();
    EXPECT_EQ(motion.nearPlane, (Ids{0, 1}));
    EXPECT_EQ(motion.dynamicCasters, (Ids{2, 3}));
    EXPECT_TRUE(motion.staticCasters.empty());
}

TEST_F(LightMotionTest, ADirectionalLightHasNoNearPlane) {
    scene_.lightOpen.kind = scene_.lightClose.kind = LightKind::Directional;
    add({0, 0, 9}, {0, 0, 11});
    add({0, 0, 0}, {0, 0, 0});
    const LightMotion motion = classify();
    EXPECT_EQ(motion.dynamicCasters, (Ids{0, 1}));
    EXPECT_EQ(motion.staticCasters, (Ids{2, 3}));
    EXPECT_TRUE(motion.nearPlane.empty());
}

TEST_F(LightMotionTest, CountsNonTranslatingTriangles) {
    add({0, 0, 5}, {1, 0, 5});
    MovingQuad turned = slidingQuad({0, 0, 4}, {0, 0, 4}, 0.5, -0.5, 0.5);
    turned.close[0] += glm::dvec3(0.0, 0.2, 0.0);  // of both its triangles
    scene_.quads.push_back(turned);
    const LightMotion motion = classify();
    EXPECT_EQ(motion.dynamicCasters.size(), 4u);
    EXPECT_EQ(motion.nonTranslating, 2u);
}

}  // namespace
}  // namespace timeshade
