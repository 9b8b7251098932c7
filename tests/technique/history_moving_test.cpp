// The technique `history` while the camera, casters, receivers or the light move.
#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "scene/camera.h"
#include "scene_catalogue.h"
#include "support/drawn_view.h"
#include "technique/history_scenes.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

/// A moving shadow leaves no ghost, and static shadows go on converging.
TEST(HistoryMoving, NoGhostFollowsAShadow) {
    const auto scene = boardScene({0.04, 0.01, 0.0});
    const glm::dvec3 post[4] = {{-1.1, -0.5, 0.5}, {-0.8, -0.6, 0.6}, {-0.7, 0.7, 0.7}, {-1.0, 0.6, 0.5}};
    MovingQuad still{};
    for (int i = 0; i < 4; ++i) {
        still.open[i] = still.close[i] = post[i];
        scene->quads[1].open[i].x += 0.9;  // so that the two shadows are apart
        scene->quads[1].close[i].x += 0.9;
    }
    scene->quads.push_back(still);
    scene->finish();
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    std::vector<std::vector<float>> truths, alones, lits;
    for (int frame = 0; frame < 60; ++frame) {
        FrameRequest request = staticRequest(96, 72, 64);
        request.cameraPose = scene->cameraOpen;  // exactly the same in every frame, so that pixels converge
        request.frame = frame;
        const FramePlan plan = planner.plan(request);
        truths.push_back(truthOf(plan));
        alones.push_back(drawnLit(plan, *makeHistory()));
        lits.push_back(drawnLit(plan, *technique));
    }
    // A ghost would be where the oracle's value has just changed: there the history must have been dropped.
    std::vector<char> everChanged(truths[0].size());
    for (std::size_t frame = 1; frame < truths.size(); ++frame)
        for (std::size_t i = 0; i < everChanged.size(); ++i) {
            if (truths[frame][i] == truths[frame - 1][i]) continue;
            everChanged[i] = 1;
            EXPECT_EQ(lits[frame][i], alones[frame][i]) << "pixel " << i << " frame " << frame;
        }
    const auto wrong = [&](const std::vector<std::vector<float>>& shown, bool changed) {
        double sum = 0.0;
        for (std::size_t i = 0; i < everChanged.size(); ++i)
            if ((everChanged[i] != 0) == changed)
                sum += static_cast<double>(std::abs(shown.back()[i] - truths.back()[i]));
        return sum;
    };
    RecordProperty("wrong", std::to_string(wrong(alones, true)) + " " + std::to_string(wrong(lits, true)) +
                                ", static " + std::to_string(wrong(alones, false)) + " " +
                                std::to_string(wrong(lits, false)));
    EXPECT_LE(wrong(lits, true), wrong(alones, true) + 1e-3);
    // Beside the static shadow that includes edges of the moving one along which it slides: their history is dropped
    // as well.
    EXPECT_LT(wrong(lits, false), 0.7 * wrong(alones, false));
}

/// What should not change flickers at most a quarter as much as the same jittered maps without a history.
TEST(HistoryMoving, ASlowCameraSeesLittleFlicker) {
    const auto scene = boardScene({}, {0.004, 0.002, 0.0});
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    std::vector<float> truthBefore, aloneBefore, litBefore;
    double aloneChange = 0.0, litChange = 0.0;
    for (int frame = 0; frame < 120; ++frame) {
        FrameRequest request = staticRequest(96, 72, 48);
        request.frame = frame;
        const FramePlan plan = planner.plan(request);
        const std::vector<float> truth = truthOf(plan), alone = drawnLit(plan, *makeJitteredMap()),
                                 lit = drawnLit(plan, *technique);
        for (std::size_t i = 0; frame > 8 && i < truth.size(); ++i) {
            if (truth[i] != truthBefore[i]) continue;
            aloneChange += std::abs(static_cast<double>(alone[i] - aloneBefore[i]));
            litChange += std::abs(static_cast<double>(lit[i] - litBefore[i]));
        }
        truthBefore = truth;
        aloneBefore = alone;
        litBefore = lit;
    }
    RecordProperty("flicker", std::to_string(litChange / aloneChange));
    EXPECT_LT(litChange, 0.25 * aloneChange);
}

/// On chess, over 60 frames: of the pixels that a shadow has just come to or left no more are wrong than with an
/// ordinary map, and of all fewer than half as many.
TEST(HistoryMoving, ChessIsBetterThanWithAnOrdinaryMap) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    const std::unique_ptr<Technique> ordinary = makeTechnique("static", sharedRenderer().programs());
    std::vector<float> truthBefore;
    struct {
        int all = 0, dynamicPixels = 0;
    } pixels, wrong, wrongByMap;
    for (int frame = 0; frame < 60; ++frame) {
        FrameRequest request = staticRequest(96, 72, 128);
        request.shutter.framesPerSecond = scene->defaults().framesPerSecond;
        request.frame = frame;
        const FramePlan plan = planner.plan(request);
        const std::vector<float> truth = truthOf(plan), map = drawnLit(plan, *ordinary),
                                 lit = drawnLit(plan, *technique);
        for (std::size_t i = 0; i < truth.size(); ++i) {
            const int dynamicPixels = frame > 0 && truth[i] != truthBefore[i] ? 1 : 0;
            const int off = std::abs(lit[i] - truth[i]) > 0.5f ? 1 : 0,
                      offByMap = std::abs(map[i] - truth[i]) > 0.5f ? 1 : 0;
            pixels.dynamicPixels += dynamicPixels;
            wrong.all += off;
            wrong.dynamicPixels += off * dynamicPixels;
            wrongByMap.all += offByMap;
            wrongByMap.dynamicPixels += offByMap * dynamicPixels;
        }
        truthBefore = truth;
    }
    RecordProperty("wrong", fmt::format("{} of {} touched, {} in all; by an ordinary map {}, {}", wrong.dynamicPixels,
                                        pixels.dynamicPixels, wrong.all, wrongByMap.dynamicPixels, wrongByMap.all));
    EXPECT_GT(pixels.dynamicPixels, 500);
    EXPECT_LE(wrong.dynamicPixels, wrongByMap.dynamicPixels);
    EXPECT_LT(2 * wrong.all, wrongByMap.all);
}

/// At a grazing angle a pixel's neighbours lie far apart in depth but in one plane: the floor keeps its history while
/// the camera slides. As published, by filtered depth, it does so with the samples at pixel centres that it asks for;
/// with one at a random place of each pixel, no filter finds the depth between them.
TEST(HistoryMoving, AGrazedFloorKeepsItsHistory) {
    const auto scene = boardScene();
    for (CameraPose* camera : {&scene->cameraOpen, &scene->cameraClose})
        *camera = lookAt({0.0, -1.6, 0.25}, {0.0, 0.0, 0.1}, {0.0, 0.0, 1.0}, 0.6, 0.01);
    scene->cameraClose.eye += glm::dvec3(0.01, 0.02, 0.0);
    scene->finish();
    FramePlanner planner(*scene);
    const auto keptBy = [&](const char* published, bool asAsked) {
        const auto technique = makeHistory();
        setFromText(*technique, "as_published", published);
        FrameRequest request = staticRequest(32, 24, 32);
        if (asAsked) request = technique->asked(request);
        for (; request.frame < 4.0; request.frame += 1.0) drawnLit(planner.plan(request), *technique);
        const std::vector<float> lengths = drawnView(planner.plan(request), *technique, "history-length");
        const auto tested = std::count_if(lengths.begin(), lengths.end(), [](float length) { return length >= 1.0f; });
        const auto kept = std::count(lengths.begin(), lengths.end(), 5.0f);
        return static_cast<double>(kept) / static_cast<double>(tested);
    };
    const double repaired = keptBy("off", true), published = keptBy("on", true), anywhere = keptBy("on", false);
    RecordProperty("history kept",
                   std::to_string(repaired) + " " + std::to_string(published) + " " + std::to_string(anywhere));
    EXPECT_GT(repaired, 0.9);
    EXPECT_GT(published, 0.85);  // at an edge the filtered depth is neither surface's
    EXPECT_LT(anywhere, 0.3);
}

/// A receiver is followed: a floor that slides with its camera keeps its history, as long as no shadow slides over it.
TEST(HistoryMoving, AReceiverIsFollowed) {
    auto scene = std::make_shared<ProceduralScene>();
    scene->quads.push_back(slidingQuad({0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, 4.0, -4.0, 4.0));
    const auto board = boardScene();
    scene->lightOpen = scene->lightClose = board->lightOpen;
    scene->cameraOpen = scene->cameraClose = board->cameraOpen;
    scene->finish();
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    FrameRequest request = staticRequest(24, 18, 32);
    for (; request.frame < 5.0; request.frame += 1.0) drawnLit(planner.plan(request), *technique);
    const std::vector<float> lengths = drawnView(planner.plan(request), *technique, "history-length");
    const auto old = std::count(lengths.begin(), lengths.end(), 6.0f);
    EXPECT_GT(old, static_cast<std::ptrdiff_t>(lengths.size() / 2));
}

TEST(HistoryMoving, AMovingLightInvalidatesTheHistory) {
    const auto scene = boardScene();
    scene->lightClose.position.x += 0.05;
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    FrameRequest request = staticRequest(24, 18, 32);
    for (; request.frame < 3.0; request.frame += 1.0) drawnLit(planner.plan(request), *technique);
    const std::vector<float> lengths = drawnView(planner.plan(request), *technique, "history-length");
    EXPECT_EQ(*std::max_element(lengths.begin(), lengths.end()), 1.0f);
}

}  // namespace
}  // namespace timeshade
