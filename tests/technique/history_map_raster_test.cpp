// What the map of the technique `history` covers.
#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "technique/history_scenes.h"
#include "techniques/history/map_raster.h"
#include "techniques/history/seen_body.h"

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
            const glm::dmat3 map = mapRaster(plan, fit, MapJitter::ShiftAndTurn, static_cast<std::uint32_t>(i));
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

TEST(MapRaster, DuellingFrustaHaveNoWarp) {
    const auto scene = boardScene();
    // A directional light straight down, and the camera straight up into its face.
    scene->lightOpen.kind = scene->lightClose.kind = LightKind::Directional;
    CameraPose& camera = scene->cameraOpen;
    camera.eye = {1.0, 0.5, -8.0};
    camera.axes = glm::dmat3(glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, -1.0, 0.0), glm::dvec3(0.0, 0.0, -1.0));
    scene->cameraClose = camera;
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(32, 24, 64));
    EXPECT_EQ(mapRaster(plan, MapFit::Warped, MapJitter::Shift, 3), mapRaster(plan, MapFit::Seen, MapJitter::Shift, 3));
    // And does have one when it looks across.
    const auto across = boardScene();
    const FramePlan other = FramePlanner(*across).plan(staticRequest(32, 24, 64));
    EXPECT_NE(mapRaster(other, MapFit::Warped, MapJitter::Shift, 3),
              mapRaster(other, MapFit::Seen, MapJitter::Shift, 3));
}

}  // namespace
}  // namespace timeshade
