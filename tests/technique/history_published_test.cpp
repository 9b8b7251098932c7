// The published form of the technique `history` (Scherzer, Jeschke, Wimmer 2007): one switch is all of the paper.
#include <algorithm>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene_catalogue.h"
#include "support/drawn_view.h"
#include "technique/history_scenes.h"

namespace timeshade {
namespace {

std::unique_ptr<HistoryShadow> makePublished() {
    auto technique = makeHistory();
    setFromText(*technique, "as_published", "on");
    return technique;
}

/// Triangle of every camera sample.
std::vector<std::uint32_t> idsOf(const FramePlan& plan) {
    truthOf(plan);
    return sharedRenderer().readSampleIds();
}

/// Which surface each pixel sees: its mesh instance, -1 for none. With one sample a pixel.
std::vector<int> surfacesOf(const FramePlan& plan, const std::vector<std::uint32_t>& ids) {
    std::vector<int> surfaces;
    for (const std::uint32_t id : ids)
        surfaces.push_back(id == NO_TRIANGLE ? -1 : static_cast<int>(plan.mesh->topology->triangleInstances[id]));
    return surfaces;
}

/// Where the camera of `before` saw what the camera of `now` sees in a pixel, in pixels with centres at whole numbers.
class Reprojection {
  public:
    Reprojection(const FramePlan& now, const FramePlan& before) : now_(now), before_(before) {}

    glm::dvec2 placeOf(int x, int y, std::uint32_t id) const {
        const glm::u32vec3& t = now_.mesh->topology->triangles[id];
        const glm::dvec3 a = now_.mesh->positionsOpen[t[0]] - now_.origin;
        const glm::dvec3 normal = glm::cross(now_.mesh->positionsOpen[t[1]] - now_.origin - a,
                                             now_.mesh->positionsOpen[t[2]] - now_.origin - a);
        const ViewEnd& camera = now_.camera.open;
        const glm::dvec3 ray = camera.corner + camera.right * ((x + 0.5) / now_.request.width) +
                               camera.up * ((y + 0.5) / now_.request.height);
        const glm::dvec3 p = camera.eye + ray * (glm::dot(a - camera.eye, normal) / glm::dot(ray, normal));
        const ViewEnd& past = before_.camera.open;
        const glm::dvec3 q = glm::inverse(glm::dmat3(past.right, past.up, past.corner)) * (p - past.eye);
        return glm::dvec2(q) / q.z * glm::dvec2(now_.request.width, now_.request.height) - 0.5;
    }

  private:
    const FramePlan &now_, &before_;
};

/// On the camera path of frusta, frames in sequence, nearly every fragment finds its past; whatever is rejected lies at
/// an edge, where the four texels that are filtered saw other surfaces (disocclusions), or is new in the picture.
TEST(HistoryPublished, KeepsItsPastOutsideOfDisocclusions) {
    const std::unique_ptr<Scene> scene = openScene("frusta", "");
    FramePlanner planner(*scene);
    const auto technique = makePublished();
    FrameRequest request = staticRequest(240, 180, 128);
    request.shutter.framesPerSecond = scene->defaults().framesPerSecond;
    request.cameraIndex = 1;
    ASSERT_EQ(scene->cameras()[1].name, "path");
    request = technique->asked(request);
    std::optional<FramePlan> before;
    std::vector<int> surfacesBefore;
    int seen = 0, rejected = 0, inside = 0, rejectedInside = 0;
    for (request.frame = 0.0; request.frame < 8.0; request.frame += 1.0) {
        const FramePlan plan = planner.plan(request);
        const std::vector<float> view = drawnView(plan, *technique, "rejected");
        const std::vector<std::uint32_t> ids = idsOf(plan);
        const std::vector<int> surfaces = surfacesOf(plan, ids);
        for (std::size_t i = 0; before && i < view.size(); ++i) {
            if (surfaces[i] < 0) continue;
            const int x = static_cast<int>(i) % request.width, y = static_cast<int>(i) / request.width;
            const glm::dvec2 place = Reprojection(plan, *before).placeOf(x, y, ids[i]);
            const glm::ivec2 corner(glm::floor(place));
            bool same = corner.x >= 0 && corner.y >= 0 && corner.x + 1 < request.width && corner.y + 1 < request.height;
            for (int k = 0; same && k < 4; ++k)
                same =
                    surfacesBefore[static_cast<std::size_t>((corner.y + k / 2) * request.width + corner.x + k % 2)] ==
                    surfaces[i];
            ++seen;
            rejected += view[i] == 1.0f ? 1 : 0;
            inside += same ? 1 : 0;
            rejectedInside += same && view[i] == 1.0f ? 1 : 0;
        }
        before = plan;
        surfacesBefore = surfaces;
    }
    RecordProperty("rejected",
                   fmt::format("{} of {}, outside of disocclusions {} of {}", rejected, seen, rejectedInside, inside));
    EXPECT_GT(inside, seen / 2);
    EXPECT_LT(rejectedInside, inside / 10);
}

/// Every fragment has a place in the history, also one that faces away from the light; only where nothing is seen there
/// is none.
TEST(HistoryPublished, EveryFragmentHasAPlace) {
    const auto scene = boardScene();
    MovingQuad underside = slidingQuad({0.3, -0.5, 1.0}, {0.3, -0.5, 1.0}, 0.2, -0.2, 0.2);
    std::swap(underside.open[1], underside.open[3]);  // its front is below, away from the light
    std::swap(underside.close[1], underside.close[3]);
    scene->quads.push_back(underside);
    for (CameraPose* camera : {&scene->cameraOpen, &scene->cameraClose})
        *camera = lookAt({0.0, -2.5, 0.3}, {0.0, 0.0, 0.8}, {0.0, 0.0, 1.0}, 1.2, 0.01);
    scene->finish();
    const auto technique = makePublished();
    const FramePlan plan = FramePlanner(*scene).plan(technique->asked(staticRequest(48, 36, 64)));
    const std::vector<float> lengths = drawnView(plan, *technique, "history-length");
    const std::vector<std::uint32_t> ids = idsOf(plan);
    const auto ofUnderside = static_cast<std::uint32_t>(2 * (scene->quads.size() - 1));
    int nothing = 0, facingAway = 0;
    for (std::size_t i = 0; i < ids.size(); ++i) {
        EXPECT_EQ(lengths[i], ids[i] == NO_TRIANGLE ? -1.0f : 1.0f);
        nothing += ids[i] == NO_TRIANGLE ? 1 : 0;
        facingAway += ids[i] != NO_TRIANGLE && ids[i] >= ofUnderside ? 1 : 0;
    }
    EXPECT_GT(nothing, 20);
    EXPECT_GT(facingAway, 5);
}

/// What the settings of the repaired form say is of no matter.
TEST(HistoryPublished, OneSwitchIsAllOfIt) {
    const auto scene = boardScene();
    FramePlanner planner(*scene);
    const FrameRequest request = staticRequest(48, 36, 16);
    const auto drawn = [&](const std::vector<std::pair<const char*, const char*>>& settings) {
        const auto technique = makePublished();
        for (const auto& [key, value] : settings) setFromText(*technique, key, value);
        EXPECT_TRUE(technique->asked(request).pixelCentres);
        const FramePlan plan = planner.plan(technique->asked(request));
        for (int frame = 0; frame < 3; ++frame) drawnLit(plan, *technique);
        return drawnLit(plan, *technique);
    };
    const std::vector<float> published = drawn({});
    EXPECT_EQ(drawn({{"jitter", "0"}, {"fit", "0"}, {"bias", "16"}, {"slope_bias", "0"}, {"sharpen", "1"}}), published);
    EXPECT_NE(drawn({{"published_bias", "16"}}), published) << "which bridges the board's height";
    EXPECT_NE(drawn({{"m_still", "3"}, {"m", "1"}}), published) << "the exponent is the user's";
    EXPECT_FALSE(makeHistory()->asked(request).pixelCentres);
}

/// Smoothed test and depth are stored as half floats (section 4).
TEST(HistoryPublished, StoresHalves) {
    const auto scene = boardScene();
    const auto technique = makePublished();
    const FramePlan plan = FramePlanner(*scene).plan(technique->asked(staticRequest(64, 48, 128)));
    drawnLit(plan, *technique);
    EXPECT_EQ(technique->bytes(), std::size_t{2 * 8 * 64 * 48 + 4 * 128 * 128} + sizeof(shared::HistoryBlock));
    // A static camera needs nothing more.
    drawnLit(plan, *technique);
    EXPECT_EQ(technique->bytes(), std::size_t{2 * 8 * 64 * 48 + 4 * 128 * 128} + sizeof(shared::HistoryBlock));
}

}  // namespace
}  // namespace timeshade
