// What the map of the technique `history` covers.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "passes/seen_body.h"
#include "scene_catalogue.h"
#include "technique/history_scenes.h"
#include "techniques/history/map_raster.h"

namespace timeshade {
namespace {

/// Whatever is seen lies inside the fitted map, in front of the warp's horizon; and where light and camera face each
/// other along one line (duelling frusta) there is no warp.
TEST(MapRaster, CoversWhatIsSeen) {
    Lots lots;
    for (int i = 0; i < 200; ++i) {
        const auto scene = boardScene();
        CameraPose& camera = scene->cameraOpen;
        camera.eye = {4.0 * lots.next() - 2.0, -3.0 * lots.next() - 0.5, 0.2 + 3.0 * lots.next()};
        const glm::dvec3 back = glm::normalize(camera.eye - glm::dvec3(lots.next() - 0.5, 2.0 * lots.next(), 0.0));
        const glm::dvec3 right = glm::normalize(glm::cross(glm::dvec3(0.0, 0.0, 1.0), back));
        camera.axes = glm::dmat3(right, glm::cross(back, right), back);
        scene->cameraClose = camera;
        const FramePlan plan = FramePlanner(*scene).plan(staticRequest(32, 24, 64));
        for (const MapFit fit : {MapFit::Light, MapFit::Seen, MapFit::Warped}) {
            const glm::dmat3 map =
                mapRaster(plan, fit, MapJitter::ShiftAndTurn, static_cast<std::uint32_t>(i)).mapFromPlane;
            for (int k = 0; k < 64; ++k) {
                // A random ray of the camera to the floor.
                const glm::dvec3 ray =
                    plan.camera.open.corner + plan.camera.open.right * lots.next() + plan.camera.open.up * lots.next();
                const double far = -(plan.camera.open.eye.z + plan.origin.z) / ray.z;
                const glm::dvec3 p = plan.camera.open.eye + ray * far;
                const glm::dvec2 onPlane = onMapPlane(plan.light, p);
                const glm::dvec3 world = p + plan.origin;
                const bool seen = far > 0.0 && std::max(std::abs(world.x), std::abs(world.y)) < 6.0;
                if (!seen || glm::distance(onPlane, glm::dvec2(0.5)) > 0.5) continue;
                const glm::dvec3 h = map * glm::dvec3(onPlane, 1.0);
                ASSERT_GE(h.z, 1.0 - 1e-9);
                const glm::dvec2 q = glm::dvec2(h) / h.z;
                ASSERT_TRUE(q.x >= 0.0 && q.x <= 1.0 && q.y >= 0.0 && q.y <= 1.0)
                    << q.x << " " << q.y << " fit " << static_cast<int>(fit);
            }
        }
    }
}

/// A camera that moves and turns within the shutter, and a light that moves: what is seen at any time of it lies inside
/// the fitted map as the light sees it then.
TEST(MapRaster, CoversWhatIsSeenOnTheWay) {
    Lots lots;
    int seenAtAll = 0, fittedMaps = 0;
    for (int i = 0; i < 120; ++i) {
        const auto scene = boardScene();
        const auto poseAt = [&] {
            return lookAt({4.0 * lots.next() - 2.0, -3.0 * lots.next() - 0.5, 0.2 + 3.0 * lots.next()},
                          {lots.next() - 0.5, 2.0 * lots.next(), 0.0}, {0.0, 0.0, 1.0}, 0.5 + lots.next(), 0.01);
        };
        scene->cameraOpen = poseAt();
        if (i % 3 != 0) scene->cameraClose = poseAt();
        if (i % 3 == 0) scene->cameraClose = scene->cameraOpen;
        scene->cameraClose.verticalFieldOfView = scene->cameraOpen.verticalFieldOfView;
        if (i % 3 != 1) scene->lightClose.position += glm::dvec3(lots.next() - 0.5, lots.next() - 0.5, -lots.next());
        scene->finish();
        FrameRequest request = staticRequest(32, 24, 64);
        request.shutter.length = 1.0;
        const FramePlan plan = FramePlanner(*scene).plan(request);
        const FittedMap fitted =
            mapRaster(plan, MapFit::Warped, MapJitter::ShiftAndTurn, static_cast<std::uint32_t>(i));
        EXPECT_EQ(fitted.shortfall, "");
        fittedMaps += glm::determinant(glm::dmat2(fitted.mapFromPlane)) > 2.0 ? 1 : 0;
        for (int k = 0; k < 200; ++k) {
            const double u = k % 3 == 0 ? 0.5 : lots.next(), s = lots.next(), t = lots.next();
            const ViewEnd &a = plan.camera.open, &b = plan.camera.close;
            const glm::dvec3 eye = glm::mix(a.eye, b.eye, u),
                             ray = glm::mix(a.corner + s * a.right + t * a.up, b.corner + s * b.right + t * b.up, u);
            const double far = -(eye.z + plan.origin.z) / ray.z;
            const glm::dvec3 p = eye + ray * far, world = p + plan.origin;
            if (!(far > 0.0) || std::max(std::abs(world.x), std::abs(world.y)) > 6.0) continue;
            const glm::dvec3 v =
                glm::mix(glm::dvec3(glm::dmat4(plan.light.block.viewFromWorldOpen) * glm::dvec4(p, 1.0)),
                         glm::dvec3(glm::dmat4(plan.light.block.viewFromWorldClose) * glm::dvec4(p, 1.0)), u);
            const glm::dvec2 onPlane = glm::dvec2(v) / v.z;
            if (glm::distance(onPlane, glm::dvec2(0.5)) > 0.5) continue;
            ++seenAtAll;
            const glm::dvec3 h = fitted.mapFromPlane * glm::dvec3(onPlane, 1.0);
            ASSERT_GE(h.z, 1.0 - 1e-9);
            const glm::dvec2 q = glm::dvec2(h) / h.z;
            ASSERT_TRUE(q.x >= 0.0 && q.x <= 1.0 && q.y >= 0.0 && q.y <= 1.0) << q.x << " " << q.y << " at u " << u;
        }
    }
    EXPECT_GT(seenAtAll, 5000);
    EXPECT_GT(fittedMaps, 20) << "maps that show the light's whole reach cover everything";
}

/// The warp is weakened where the turned map would reach beyond its horizon; the map is never given up for it.
TEST(MapRaster, AWarpLeavesTheMapBeforeItsHorizon) {
    const std::unique_ptr<Scene> scene = openScene("frusta", "");
    FramePlanner planner(*scene);
    FrameRequest request = staticRequest(64, 48, 512);
    request.shutter = {scene->defaults().framesPerSecond, 0.5, ShutterPosition::Start};
    request.cameraIndex = 1;
    int weakened = 0;
    for (request.frame = 0.0; request.frame < 24.0; request.frame += 1.0) {
        const FramePlan plan = planner.plan(request);
        EXPECT_TRUE(plan.motion.cameraMoves);
        const auto index = static_cast<std::uint32_t>(request.frame);
        const FittedMap warped = mapRaster(plan, MapFit::Warped, MapJitter::ShiftAndTurn, index);
        EXPECT_EQ(warped.shortfall, "");
        EXPECT_GT(warped.warp, 0.05);
        EXPECT_LE(warped.warp, 1.0);
        weakened += warped.warp < 1.0 ? 1 : 0;
        const glm::dmat3 planeFromMap = glm::inverse(warped.mapFromPlane);
        for (const glm::dvec2 corner : {glm::dvec2(0, 0), glm::dvec2(1, 0), glm::dvec2(0, 1), glm::dvec2(1, 1)}) {
            const double inverseWeight = (planeFromMap * glm::dvec3(corner, 1.0)).z;
            EXPECT_GT(inverseWeight, 0.99e-3);
            EXPECT_LE(inverseWeight, 1.0 + 1e-9);
        }
    }
    RecordProperty("weakened", weakened);
}

/// Where a fit is not what was asked for, the plan's lines say why.
TEST(MapRaster, ShortfallsAreWarnedOf) {
    const auto moving = boardScene({}, {0.1, 0.0, 0.0});
    FrameRequest request = staticRequest(32, 24, 64);
    request.shutter.length = 1.0;
    const FramePlan plan = FramePlanner(*moving).plan(request);
    const auto technique = makeHistory();
    ASSERT_EQ(technique->warnings(plan).size(), 1u);
    EXPECT_NE(technique->warnings(plan)[0].find("the camera moves"), std::string::npos);
    setFromText(*technique, "fit", "lispsm");
    EXPECT_TRUE(technique->warnings(plan).empty());
    setFromText(*technique, "fit", "whole-light");
    EXPECT_TRUE(technique->warnings(plan).empty());
}

TEST(MapRaster, DuellingFrustaHaveNoWarp) {
    const auto scene = boardScene();
    // A directional light straight down, and the camera straight up into its face.
    scene->lightOpen.kind = scene->lightClose.kind = LightKind::Directional;
    CameraPose& camera = scene->cameraOpen;
    camera.eye = {1.0, 0.5, -8.0};
    camera.axes = glm::dmat3(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, -1.0));
    scene->cameraClose = camera;
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(32, 24, 64));
    EXPECT_EQ(mapRaster(plan, MapFit::Warped, MapJitter::Shift, 3).mapFromPlane,
              mapRaster(plan, MapFit::Seen, MapJitter::Shift, 3).mapFromPlane);
    EXPECT_NE(mapRaster(plan, MapFit::Warped, MapJitter::Shift, 3).shortfall.find("duelling frusta"),
              std::string::npos);
    // And does have one when it looks across.
    const auto across = boardScene();
    const FramePlan other = FramePlanner(*across).plan(staticRequest(32, 24, 64));
    EXPECT_NE(mapRaster(other, MapFit::Warped, MapJitter::Shift, 3).mapFromPlane,
              mapRaster(other, MapFit::Seen, MapJitter::Shift, 3).mapFromPlane);
}

}  // namespace
}  // namespace timeshade
