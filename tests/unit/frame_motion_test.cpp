// The plan's facts about each triangle, and what may be cached from frame to frame.
#include <gtest/gtest.h>

#include <cmath>

#include "cases/procedural_scene.h"
#include "plan/frame_plan.h"
#include "scene_catalogue.h"
#include "support/awkward_numbers.h"

namespace timeshade {
namespace {

class FrameMotion : public testing::Test {
  protected:
    FrameMotion() {
        scene_.lightOpen.position = {0.0, 0.0, 10.0};
        scene_.lightOpen.outerConeAngle = 0.6;
        scene_.lightClose = scene_.lightOpen;
        scene_.cameraOpen = scene_.cameraClose = lookAt({0.0, 0.0, 20.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.6, 0.01);
    }

    void add(glm::dvec3 from, glm::dvec3 to) { scene_.quads.push_back(slidingQuad(from, to, 0.5, -0.5, 0.5)); }
    void addTriangle(const MovingCorners& corners) { scene_.triangles.push_back(corners); }
    static FrameRequest request() { return ProceduralScene::request(32, 32, 2, 64, 1); }
    FramePlan plan() {
        scene_.finish();
        return FramePlanner(scene_).plan(request());
    }
    const TriangleMotion& of(const FramePlan& p, std::size_t id) { return (*p.triangles)[id]; }

    ProceduralScene scene_;
};

TEST_F(FrameMotion, ClassifiesMotionRelativeToWorldLightAndCamera) {
    add({0, 0, 0}, {0, 0, 0});
    add({1, 0, 0}, {2, 0, 0});
    scene_.lightClose.position.x = 1.0;
    const FramePlan p = plan();
    EXPECT_FALSE(of(p, 0).movesInWorld);
    EXPECT_FALSE(of(p, 0).camera.moves);
    EXPECT_TRUE(of(p, 0).light.moves);  // the light does
    EXPECT_FALSE(of(p, 0).nonTranslating);
    EXPECT_TRUE(of(p, 2).movesInWorld);
    EXPECT_TRUE(of(p, 2).camera.moves);
}

TEST_F(FrameMotion, TellsRotationFromTranslation) {
    addTriangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{1, 0, 0}, {2, 0, 0}, {1, 1, 0}}});
    addTriangle({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}}});
    const FramePlan p = plan();
    EXPECT_FALSE(of(p, 0).nonTranslating);
    EXPECT_TRUE(of(p, 1).nonTranslating);
    EXPECT_EQ(p.motion.instances, 2u);
    EXPECT_EQ(p.motion.movingInstances, 2u);
    EXPECT_EQ(p.motion.nonTranslatingInstances, 1u);
}

TEST_F(FrameMotion, NamesASideOnlyWhereItIsTheSameThroughout) {
    const glm::dvec3 a{0, 0, 0}, b{1, 0, 0}, c{0, 1, 0};
    addTriangle({{a, b, c}, {a, b, c}});
    addTriangle({{a, c, b}, {a, c, b}});
    addTriangle({{a, b, c}, {a, b, -c}});  // turns over
    const FramePlan p = plan();
    EXPECT_EQ(of(p, 0).light.facing, Facing::Towards);
    EXPECT_EQ(of(p, 0).camera.facing, Facing::Towards);
    EXPECT_EQ(of(p, 1).light.facing, Facing::Away);
    EXPECT_EQ(of(p, 2).light.facing, Facing::Unsure);
}

TEST_F(FrameMotion, ListsWhatComesIntoAView) {
    add({0, 0, 0}, {0, 0, 0});
    add({60, 0, 0}, {50, 0, 0});
    add({-60, 0, 0}, {60, 0, 0});    // passes through between the ends
    add({0, 0, 9.5}, {0, 0, 10.5});  // past the light
    const FramePlan p = plan();
    EXPECT_EQ(of(p, 0).light.reach, Reach::Inside);
    EXPECT_EQ(of(p, 2).light.reach, Reach::Outside);
    EXPECT_EQ(of(p, 2).camera.reach, Reach::Outside);
    EXPECT_EQ(of(p, 4).light.reach, Reach::Crossing);
    EXPECT_TRUE(of(p, 6).light.reachesNearPlane);
    EXPECT_FALSE(of(p, 0).light.reachesNearPlane);
}

/// A moving object that neither view sees, and whose shadow the camera does not see, is in no list.
TEST_F(FrameMotion, WhatCannotMatterIsInNoList) {
    add({0, 0, 0}, {0, 0, 0});
    add({60, 0, 0}, {61, 0, 0});
    FramePlan p = plan();
    EXPECT_TRUE(p.casters.nothingMoves());
    EXPECT_EQ(p.light.dynamicTriangles.count() + p.camera.dynamicTriangles.count(), 0u);

    // Inside the light's cone, but its shadow falls where the camera does not look.
    scene_.cameraOpen = scene_.cameraClose = lookAt({-3.0, 0.0, 6.0}, {-3.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 0.3, 0.01);
    scene_.quads[1] = slidingQuad({3, 0, 2}, {3.5, 0, 2}, 0.5, -0.5, 0.5);
    p = plan();
    EXPECT_EQ(of(p, 2).light.reach, Reach::Inside);
    EXPECT_FALSE(of(p, 2).shadowMayBeSeen);
    EXPECT_TRUE(p.casters.nothingMoves());
    EXPECT_EQ(p.light.unseenTriangles, 2u);
    FrameRequest everything = request();
    everything.forceDynamic = true;
    const FramePlan all = FramePlanner(scene_).plan(everything);
    EXPECT_EQ(all.casters.dynamicCasters.size(), 4u);
    EXPECT_EQ(all.versions.lit, 0u);
}

/// If the camera sees a point behind a caster, its shadow may be seen.
TEST(ShadowReach, NeverDropsAShadowThatIsSeen) {
    AwkwardNumbers numbers(77);
    const auto point = [&](float size) {
        const float x = numbers.between(-size, size), y = numbers.between(-size, size),
                    z = numbers.between(-size, size);
        return glm::dvec3(x, y, z);
    };
    int dropped = 0, seen = 0;
    for (int i = 0; i < 3000; ++i) {
        ProceduralScene scene;
        const glm::dvec3 centre = point(3), way = point(1);
        MovingCorners& corners = scene.triangles.emplace_back();
        for (int c = 0; c < 3; ++c) {
            corners.open[c] = centre + 0.5 * point(1);
            corners.close[c] = centre + way + 0.5 * point(1);
        }
        scene.triangles.push_back({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
        scene.cameraOpen = scene.cameraClose = lookAt(point(6), point(2), {0.1, 0.2, 1.0}, 0.6, 0.01);
        scene.cameraClose.eye += 0.2 * point(1);
        scene.lightOpen = {};
        scene.lightOpen.position = point(9);
        scene.lightClose = scene.lightOpen;
        scene.lightClose.position += point(1);
        scene.finish();
        const FramePlan plan = FramePlanner(scene).plan(ProceduralScene::request(16, 16, 2, 64, 1));
        const bool kept = (*plan.triangles)[0].shadowMayBeSeen;
        dropped += kept ? 0 : 1;
        for (int k = 0; k < 200; ++k) {
            const double u = static_cast<double>(numbers.unit());
            double a = static_cast<double>(numbers.unit()), b = static_cast<double>(numbers.unit());
            if (a + b > 1.0) {
                a = 1.0 - a;
                b = 1.0 - b;
            }
            const MovingCorners& t = scene.triangles[0];
            const auto corner = [&](int c) { return glm::mix(t.open[c], t.close[c], u); };
            const glm::dvec3 p = corner(0) + a * (corner(1) - corner(0)) + b * (corner(2) - corner(0));
            const glm::dvec3 light = glm::mix(scene.lightOpen.position, scene.lightClose.position, u);
            const glm::dvec3 behind = p + (p - light) * std::exp2(static_cast<double>(numbers.between(-6.0f, 4.0f)));
            const glm::dvec3 eye = glm::mix(scene.cameraOpen.eye, scene.cameraClose.eye, u);
            const glm::dvec3 v = glm::transpose(scene.cameraOpen.axes) * (behind - eye);
            const double extent = std::tan(0.3) * -v.z;
            if (!(v.z < 0.0 && std::abs(v.x) <= extent && std::abs(v.y) <= extent)) continue;
            ++seen;
            ASSERT_TRUE(kept) << "scene " << i;
            break;
        }
    }
    EXPECT_GT(dropped, 300);
    EXPECT_GT(seen, 500);
}

TEST_F(FrameMotion, NormalsAloneChangeTheVersionOfColours) {
    add({0, 0, 0}, {0, 0, 0});
    add({0, 0, 3}, {1, 0, 3});
    scene_.finish();
    const FramePlan plan = FramePlanner(scene_).plan(request());
    const FrameViews views{plan.camera, plan.light, plan.block};
    MotionClassifier classifier;
    const StaticVersions first = classifier.update(plan.texels, views).versions;
    const auto withNormal = [&](std::size_t triangle) {
        auto texels = std::make_shared<MeshTexels>(*plan.texels);
        texels->shading[triangle * TRIANGLE_SHADING_TEXELS].x += 0.5f;
        return classifier.update(texels, views).versions;
    };
    const StaticVersions ofStill = withNormal(0);
    EXPECT_EQ(ofStill.lit, first.lit);
    EXPECT_EQ(ofStill.samples, first.samples);
    EXPECT_NE(ofStill.shading, first.shading) << "a triangle that stands still has another normal";
    const StaticVersions before = classifier.update(plan.texels, views).versions;
    EXPECT_EQ(withNormal(2).shading, before.shading) << "one that moves is shaded in every frame";
}

TEST_F(FrameMotion, VersionsChangeWithStaticTrianglesAndWithNothingElse) {
    add({0, 0, 0}, {0, 0, 0});
    add({0, 0, 3}, {1, 0, 3});
    scene_.finish();
    FramePlanner planner(scene_);
    const FramePlan first = planner.plan(request());
    const auto same = [&](const StaticVersions& a, const StaticVersions& b) {
        return a.casters == b.casters && a.samples == b.samples && a.lit == b.lit && a.shading == b.shading;
    };
    EXPECT_NE(first.versions.casters, 0u);
    EXPECT_NE(first.versions.lit, 0u);
    EXPECT_EQ(first.motion.reclassified, 4u);
    FramePlan next = planner.plan(request());
    EXPECT_TRUE(same(next.versions, first.versions));
    EXPECT_EQ(next.motion.reclassified, 0u);

    FrameRequest other = request();
    other.frame = 0.25;  // the quad is elsewhere; it moves in both frames
    next = planner.plan(other);
    EXPECT_TRUE(same(next.versions, first.versions));
    EXPECT_EQ(next.motion.reclassified, 2u);

    other.seed = 9;  // other camera samples, the same casters
    next = planner.plan(other);
    EXPECT_EQ(next.versions.casters, first.versions.casters);
    EXPECT_NE(next.versions.samples, first.versions.samples);
    EXPECT_NE(next.versions.lit, first.versions.lit);

    other = request();
    other.frame = 0.25;
    const FramePlan anywhere = planner.plan(other);
    other.pixelCentres = true;
    next = planner.plan(other);
    EXPECT_EQ(next.versions.casters, anywhere.versions.casters);
    EXPECT_NE(next.versions.samples, anywhere.versions.samples);
    EXPECT_NE(next.versions.lit, anywhere.versions.lit);

    other = request();
    other.shutter.length = 0.0;  // the quad is static as well
    next = planner.plan(other);
    EXPECT_NE(next.versions.casters, first.versions.casters);
    EXPECT_TRUE(next.casters.nothingMoves());

    other.mapSize = 128;
    EXPECT_NE(planner.plan(other).versions.casters, next.versions.casters);
    EXPECT_NE(FramePlanner(scene_).plan(request()).versions.casters, first.versions.casters)
        << "another planner may mean another scene";

    other = request();
    other.useCaches = false;
    EXPECT_EQ(planner.plan(other).versions.casters, 0u);
}

TEST_F(FrameMotion, VisibilityIsCachedOnlyUnderAStaticLight) {
    add({0, 0, 0}, {0, 0, 0});
    scene_.lightClose.position.x = 0.5;
    scene_.finish();
    FramePlanner planner(scene_);
    const FramePlan p = planner.plan(request());
    EXPECT_EQ(p.versions.lit, 0u);
    EXPECT_NE(p.versions.samples, 0u);
    FrameRequest later = request();
    later.frame = 0.5;
    later.shutter.length = 0.5;
    EXPECT_EQ(planner.plan(later).versions.samples, p.versions.samples)
        << "what the camera sees is no matter of the light";
    EXPECT_TRUE(p.casters.staticCasters.empty());
}

TEST_F(FrameMotion, TheMaskHoldsEveryTexelThatACasterOverlaps) {
    add({0, 0, 0}, {0, 0, 0});
    add({-1, 0.5, 4}, {1, -0.5, 5});
    const FramePlan p = plan();
    ASSERT_EQ(p.reached.cells.size(), static_cast<std::size_t>(DynamicCasterMask::side * DynamicCasterMask::side));
    EXPECT_GT(p.reached.marked, 0u);
    EXPECT_LT(p.reached.marked, p.reached.cells.size() / 4);
    for (double u = 0.0; u <= 1.0; u += 0.01) {
        for (const glm::dvec3& offset : {glm::dvec3(0, 0, 0), glm::dvec3(0.5, 0.5, 0), glm::dvec3(-0.5, -0.5, 0)}) {
            const glm::dvec3 place = glm::mix(glm::dvec3(-1, 0.5, 4), glm::dvec3(1, -0.5, 5), u) + offset;
            const glm::vec3 v(p.light.block.viewFromWorldOpen * glm::vec4(glm::vec3(place - p.origin), 1.0f));
            const int x = static_cast<int>(v.x / v.z * DynamicCasterMask::side),
                      y = static_cast<int>(v.y / v.z * DynamicCasterMask::side);
            EXPECT_EQ(p.reached.cells[static_cast<std::size_t>(y * DynamicCasterMask::side + x)], 1) << "u = " << u;
        }
    }
}

TEST(FrameMotionOfScenes, PillarsHaveAMovingLightAndNothingThatDeforms) {
    const std::unique_ptr<Scene> scene = openScene("pillars", "");
    FrameRequest request = ProceduralScene::request(64, 48, 2, 64, 1);
    request.frame = scene->defaults().frame;
    request.shutter = {scene->defaults().framesPerSecond, scene->defaults().shutterLength, ShutterPosition::Start};
    const FramePlan plan = FramePlanner(*scene).plan(request);
    EXPECT_TRUE(plan.motion.lightMoves);
    EXPECT_EQ(plan.motion.movingTriangles, 0u);
    EXPECT_EQ(plan.motion.nonTranslatingInstances, 0u);
    EXPECT_EQ(plan.casters.nonTranslating, 0u);
    EXPECT_NE(plan.passes.front().reason.find("the light moves"), std::string::npos);
}

}  // namespace
}  // namespace timeshade
