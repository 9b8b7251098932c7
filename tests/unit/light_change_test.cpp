// A scene's light that is placed anew, changed and moved.

#include <cmath>
#include <cstring>
#include <memory>

#include <gtest/gtest.h>

#include "../broken_gltf/box_file.h"
#include "../broken_gltf/loaded.h"
#include "cases/closed_form_cases.h"
#include "measure/reference.h"
#include "measure/reference_visibility.h"
#include "plan/frame_plan.h"
#include "plan/planned_light.h"
#include "scene/light_change.h"
#include "scene_catalogue.h"

namespace timeshade {
namespace {

using namespace test;

constexpr double quarter = 1.5707963267948966;

LightPose spotAt(const glm::dvec3& position) {
    LightPose light;
    light.position = position;
    light.axes = lookAt(position, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 1.0, 1.0).axes;
    return light;
}

TEST(LightDirection, IsAVectorAndBack) {
    EXPECT_NEAR(glm::length(vectorOf({0.0, 0.0}) - glm::dvec3(0, 0, 1)), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(vectorOf({90.0, 0.0}) - glm::dvec3(1, 0, 0)), 0.0, 1e-15);
    EXPECT_NEAR(glm::length(vectorOf({123.0, 90.0}) - glm::dvec3(0, 1, 0)), 0.0, 1e-15);
    for (const LightDirection direction : {LightDirection{30.0, 40.0}, {-170.0, -5.0}, {0.0, 89.0}}) {
        const LightDirection back = directionOf(3.0 * vectorOf(direction));
        EXPECT_NEAR(back.azimuth, direction.azimuth, 1e-11);
        EXPECT_NEAR(back.elevation, direction.elevation, 1e-11);
    }
    EXPECT_EQ(directionOf(glm::dvec3(0, -2, 0)), (LightDirection{0.0, -90.0}));
}

TEST(LightChange, PlacesASpotAtItsDistanceAndAimsIt) {
    const LightPose own = spotAt({0.0, 8.0, 6.0});
    const glm::dvec3 centre(1.0, 2.0, 3.0);
    LightChange change;
    change.direction = LightDirection{90.0, 0.0};
    change.distance = 5.0;
    const LightPose placed = changed(own, own, change, centre, 7.0);
    EXPECT_NEAR(glm::length(placed.position - glm::dvec3(6, 2, 3)), 0.0, 1e-12);
    EXPECT_NEAR(glm::length(placed.axes[2] - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
    // Either alone leaves the other as it was.
    change.distance.reset();
    const double ownDistance = glm::length(own.position - centre);
    EXPECT_NEAR(glm::length(changed(own, own, change, centre, 0.0).position - centre), ownDistance, 1e-12);
    change.direction.reset();
    change.distance = 2.0;
    const glm::dvec3 towards = changed(own, own, change, centre, 0.0).position - centre;
    EXPECT_NEAR(glm::length(0.5 * towards - (own.position - centre) / ownDistance), 0.0, 1e-12);
}

TEST(LightChange, MovesTurnsAndRisesByTheFrame) {
    const LightPose own = spotAt({0.0, 0.0, 10.0});
    LightChange change;
    change.move = {1.0, 0.0, -2.0};
    const LightPose moved = changed(own, own, change, glm::dvec3(0.0), 1.5);
    EXPECT_NEAR(glm::length(moved.position - glm::dvec3(1.5, 0.0, 7.0)), 0.0, 1e-12);
    EXPECT_EQ(moved.axes, own.axes);
    change = {};
    change.turn = 30.0;
    // Counter-clockwise from above: from +z to +x.
    EXPECT_NEAR(glm::length(changed(own, own, change, glm::dvec3(0.0), 3.0).axes[2] - glm::dvec3(1, 0, 0)), 0.0, 1e-12);
    change = {};
    change.rise = 15.0;
    const glm::dvec3 risen = changed(own, own, change, glm::dvec3(0.0), 2.0).axes[2];
    EXPECT_NEAR(std::asin(risen.y), quarter / 3.0, 1e-12);
    EXPECT_NEAR(risen.x, 0.0, 1e-12);
    change.heldAt = 0.0;
    EXPECT_EQ(changed(own, own, change, glm::dvec3(0.0), 2.0).axes, own.axes);
}

TEST(LightChange, LeavesASunWithoutAPlace) {
    LightPose sun = spotAt({0.0, 5.0, 0.0});
    sun.kind = LightKind::Directional;
    LightChange change;
    change.direction = LightDirection{45.0, 30.0};
    change.distance = 3.0;
    change.move = {1.0, 1.0, 1.0};
    change.cone = 20.0;
    const LightPose placed = changed(sun, sun, change, glm::dvec3(0.0), 4.0);
    EXPECT_EQ(placed.position, sun.position);
    EXPECT_EQ(placed.outerConeAngle, sun.outerConeAngle);
    EXPECT_NEAR(glm::length(placed.axes[2] - vectorOf({45.0, 30.0})), 0.0, 1e-12);
}

/// A plan of the scene's own frame, small.
FramePlan planOf(const Scene& scene, const LightChange& change, double offset = 0.0) {
    FrameRequest request;
    request.width = 32;
    request.height = 24;
    request.mapSize = 64;
    request.frame = scene.defaults().frame + offset;
    request.shutter.framesPerSecond = scene.defaults().framesPerSecond;
    request.shutter.length = 0.5;
    request.light = change;
    return FramePlanner(scene).plan(request);
}

TEST(PlannedLight, IsTheScenesOwnUnlessItIsChanged) {
    for (const char* name : {"pillars", "cubes"}) {
        const std::unique_ptr<Scene> scene = openScene(name);
        const FramePlan plan = planOf(*scene, {});
        const double rate = scene->defaults().framesPerSecond, frame = scene->defaults().frame;
        const auto own = scene->lightEnds(frame / rate, (frame + 0.5) / rate);
        EXPECT_EQ(plan.lightOpen.position, own.open.position);
        EXPECT_EQ(plan.lightClose.position, own.close.position);
        EXPECT_EQ(plan.lightOpen.intensity, own.open.intensity);
    }
}

TEST(PlannedLight, MovesWithinTheShutterAndFromFrameToFrame) {
    const std::unique_ptr<Scene> scene = openScene("cubes");
    LightChange change;
    change.direction = LightDirection{20.0, 60.0};
    change.move = {0.4, 0.0, 0.2};
    const FramePlan plan = planOf(*scene, change), later = planOf(*scene, change, 2.0);
    const glm::dvec3 placed =
        scene->bounds().centre() +
        glm::length(lightAtOwnFrame(*scene).position - scene->bounds().centre()) * vectorOf(*change.direction);
    EXPECT_NEAR(glm::length(plan.lightOpen.position - placed), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(plan.lightClose.position - placed - 0.5 * change.move), 0.0, 1e-9);
    EXPECT_NEAR(glm::length(later.lightOpen.position - placed - 2.0 * change.move), 0.0, 1e-9);
    EXPECT_TRUE(plan.motion.lightMoves);
    EXPECT_FALSE(planOf(*scene, {}).motion.lightMoves);
}

TEST(PlannedLight, StaysAsBrightWhereverItIsPlacedAndNoBrighterThanAsked) {
    const std::unique_ptr<Scene> scene = openScene("cubes");
    const auto atCentre = [&](const LightChange& change) {
        const FramePlan plan = planOf(*scene, change);
        const double distance = glm::length(plan.lightOpen.position - scene->bounds().centre());
        return static_cast<double>(plan.block.lightIntensity.x) / (distance * distance);
    };
    const double own = atCentre({});
    LightChange near;
    near.distance = 3.0;
    EXPECT_NEAR(atCentre(near) / own, 1.0, 1e-5);
    near.intensity = 2.0;
    EXPECT_NEAR(atCentre(near) / own, 2.0, 1e-5);
}

TEST(PlannedLight, ATurnThatIsNoStraightPathIsSaid) {
    const std::unique_ptr<Scene> scene = openScene("case:static_all");
    LightChange change;
    change.rise = 60.0;
    const FramePlan plan = planOf(*scene, change);
    EXPECT_GT(plan.motion.lightTurnDegrees, 29.0);
    change.rise = 200.0;
    EXPECT_THROW(planOf(*scene, change), Error);
}

TEST(PlannedLight, ReferencesOfAnotherLightOrGroundAreNotUsed) {
    const GltfFile file = fileWithBouncingBox();
    const TemporaryFolder folder;
    const std::filesystem::path path = folder.write("box.glb", file.glb());
    const auto keysOf = [&](const LightChange& change, const GroundSettings& ground, const DisplayLook& look) {
        const std::unique_ptr<Scene> scene = openScene(path, {.clip = {}, .light = {}, .ground = ground});
        FramePlan plan = planOf(*scene, change);
        plan.request.look = look;
        return std::pair(referenceKey(plan, {}), referenceVisibilityKey(plan, 64));
    };
    const auto own = keysOf({}, {}, {});
    EXPECT_EQ(own, keysOf({}, {}, {}));
    EXPECT_EQ(own, keysOf({}, {}, {1.0, ToneMap::Linear})) << "radiance does not know how it is shown";
    LightChange direction, distance, cone, intensity, move, turn, rise;
    direction.direction = LightDirection{20.0, 50.0};
    distance.distance = 4.0;
    cone.cone = 20.0;
    intensity.intensity = 2.0;
    move.move = {0.1, 0.0, 0.0};
    turn.turn = 3.0;
    rise.rise = 3.0;
    for (const LightChange& change : {direction, distance, cone, intensity, move, turn, rise}) {
        const auto other = keysOf(change, {}, {});
        EXPECT_NE(own.first, other.first);
        if (change != intensity) {
            EXPECT_NE(own.second, other.second);
        }
    }
    for (const GroundSettings& ground :
         {GroundSettings{GroundChoice::Off, {}, {}}, GroundSettings{GroundChoice::On, -1.0, {}},
          GroundSettings{GroundChoice::On, {}, 30.0}}) {
        EXPECT_NE(own.first, keysOf({}, ground, {}).first);
        EXPECT_NE(own.second, keysOf({}, ground, {}).second);
    }
}

}  // namespace
}  // namespace timeshade
