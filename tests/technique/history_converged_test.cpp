// The technique `history` asks no pixel in vain: those that have learned enough rest, and nobody sees it.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "scene_catalogue.h"
#include "technique/history_scenes.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

double pixelsTested(const Technique& technique) {
    for (const TechniqueStatistic& figure : technique.statistics())
        if (figure.name == "pixels tested") return figure.value;
    return -1.0;
}

/// One sample a pixel, nothing moves: dark pixels have their proof, lit ones are sure; only edges are asked on, and
/// after 64 frames nothing is.
TEST(HistoryConverged, AStillPictureIsFinished) {
    const auto scene = boardScene();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(96, 72, 64));
    const auto technique = makeHistory();
    std::vector<double> asked;
    std::vector<float> before, lit;
    for (int frame = 0; frame < 70; ++frame) {
        before = lit;
        lit = drawnLit(plan, *technique);
        asked.push_back(pixelsTested(*technique));
    }
    RecordProperty("asked",
                   std::to_string(asked[1]) + " " + std::to_string(asked[20]) + " " + std::to_string(asked[69]));
    EXPECT_EQ(asked[1], 96.0 * 72.0);
    EXPECT_LT(asked[20], 0.1 * asked[1]);
    EXPECT_EQ(asked[69], 0.0);
    EXPECT_EQ(lit, before);
    EXPECT_EQ(lit, truthOf(plan));
}

/// With several samples a pixel and an open shutter, beside something that moves, edges rest as well.
TEST(HistoryConverged, WhatNothingMovesByConverges) {
    const auto scene = boardScene();
    MovingQuad dynamicCaster = slidingQuad({1.4, 0.0, 0.5}, {1.5, 0.0, 0.5}, 0.1, -0.1, 0.1);
    scene->quads.push_back(dynamicCaster);
    scene->finish();
    FramePlanner planner(*scene);
    FrameRequest request = ProceduralScene::request(96, 72, 4, 64, 1);
    request.cameraPose = scene->cameraOpen;
    const auto technique = makeHistory();
    double first = 0.0, fewest = 1e9;
    for (request.frame = 0.0; request.frame < 24.0; request.frame += 1.0) {
        drawnLit(planner.plan(request), *technique);
        if (request.frame == 1.0) first = pixelsTested(*technique);
        fewest = std::min(fewest, pixelsTested(*technique));
    }
    RecordProperty("asked", std::to_string(first) + " " + std::to_string(fewest));
    EXPECT_LT(fewest, 0.25 * first);
    EXPECT_GT(fewest, 0.0);
}

/// What rests shows what it showed, whoever has drawn into the frame's buffers since.
TEST(HistoryConverged, OthersMayDrawInBetween) {
    const auto scene = boardScene({0.02, 0.0, 0.0});
    FramePlanner planner(*scene);
    FrameRequest request = ProceduralScene::request(48, 36, 2, 64, 1);
    request.cameraPose = scene->cameraOpen;
    const auto disturbed = makeHistory();
    FrameRenderer renderer;
    HistoryShadow undisturbed(renderer.programs());
    for (request.frame = 0.0; request.frame < 20.0; request.frame += 1.0) {
        const FramePlan plan = planner.plan(request);
        renderer.draw(plan, undisturbed, View::Visibility);
        drawnLit(plan, *makeTechnique("static", sharedRenderer().programs()));
        EXPECT_EQ(drawnLit(plan, *disturbed), renderer.readVisibility()) << "frame " << request.frame;
    }
}

/// Something lit passes before a shadow that stands still, and throws its own elsewhere: pixels that it has come to or
/// left show at once what is there, though nothing moves between the shadow and the light.
TEST(HistoryConverged, AReceiverThatComesInvalidatesAndLeavesNothing) {
    const auto scene = boardScene();
    const auto dynamicCaster = static_cast<std::uint32_t>(2 * scene->quads.size());
    scene->quads.push_back(slidingQuad({-0.17, -0.88, 1.12}, {-0.165, -0.88, 1.12}, 0.06, -0.06, 0.06));
    scene->finish();
    FramePlanner planner(*scene);
    FrameRequest request = ProceduralScene::request(96, 72, 1, 64, 1);
    request.cameraPose = scene->cameraOpen;
    const auto technique = makeHistory();
    std::vector<std::uint32_t> before;
    int changed = 0, wrong = 0, dark = 0;
    for (; request.frame < 30.0; request.frame += 1.0) {
        const FramePlan plan = planner.plan(request);
        const std::vector<float> alone = drawnLit(plan, *makeHistory()), lit = drawnLit(plan, *technique);
        const std::vector<std::uint32_t> ids = sharedRenderer().readSampleIds();
        const auto isDynamicCaster = [&](std::uint32_t id) { return id == dynamicCaster || id == dynamicCaster + 1; };
        for (std::size_t i = 0; i < before.size(); ++i) {
            if (isDynamicCaster(before[i]) == isDynamicCaster(ids[i])) continue;
            ++changed;
            dark += alone[i] == 0.0f ? 1 : 0;
            wrong += lit[i] != alone[i] ? 1 : 0;
        }
        before = ids;
    }
    RecordProperty("changed", std::to_string(changed) + ", dark " + std::to_string(dark));
    EXPECT_GT(dark, 50);
    EXPECT_GT(changed - dark, 50);
    EXPECT_EQ(wrong, 0);
}

/// The plan and what it keeps change nothing: neither what a pixel shows nor when it is asked.
TEST(HistoryConverged, IsTheSameWithoutAPlan) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FrameRenderer renderers[3];
    std::unique_ptr<HistoryShadow> techniques[3];
    std::unique_ptr<FramePlanner> planners[3];
    for (int i = 0; i < 3; ++i) {
        techniques[i] = std::make_unique<HistoryShadow>(renderers[i].programs());
        planners[i] = std::make_unique<FramePlanner>(*scene);
    }
    FrameRequest request = ProceduralScene::request(96, 72, 4, 128, 1);
    request.shutter.framesPerSecond = scene->defaults().framesPerSecond;
    std::size_t other = 0, all = 0;
    for (request.frame = 0.0; request.frame < 22.0; request.frame += 1.0) {
        std::vector<float> lit[3];
        for (int i = 0; i < 3; ++i) {
            FrameRequest own = request;
            own.forceDynamic = i == 1;
            own.useCaches = i != 2;
            renderers[i].draw(planners[i]->plan(own), *techniques[i], View::Visibility);
            lit[i] = renderers[i].readVisibility();
        }
        EXPECT_EQ(pixelsTested(*techniques[0]), pixelsTested(*techniques[2])) << "frame " << request.frame;
        for (std::size_t k = 0; k < lit[0].size(); ++k) {
            ++all;
            other += lit[1][k] != lit[0][k] || lit[2][k] != lit[0][k] ? 1u : 0u;
        }
    }
    RecordProperty("other", std::to_string(other) + " of " + std::to_string(all));
    EXPECT_LT(pixelsTested(*techniques[0]), 0.5 * 96 * 72);
    EXPECT_EQ(other, 0u);
}

}  // namespace
}  // namespace timeshade
