// Converged pixels of the technique `history` are tested only every re-test period, which changes no picture.
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

/// One sample per pixel, nothing moves: shadowed pixels are proven to be so, lit ones are sure; only edges are tested
/// on, and after 64 frames nothing is.
TEST(HistoryConverged, AStaticPictureConverges) {
    const auto scene = boardScene();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(96, 72, 64));
    const auto technique = makeHistory();
    std::vector<double> tested;
    std::vector<float> before, lit;
    for (int frame = 0; frame < 70; ++frame) {
        before = lit;
        lit = drawnLit(plan, *technique);
        tested.push_back(pixelsTested(*technique));
    }
    RecordProperty("tested",
                   std::to_string(tested[1]) + " " + std::to_string(tested[20]) + " " + std::to_string(tested[69]));
    EXPECT_EQ(tested[1], 96.0 * 72.0);
    EXPECT_LT(tested[20], 0.1 * tested[1]);
    EXPECT_EQ(tested[69], 0.0);
    EXPECT_EQ(lit, before);
    EXPECT_EQ(lit, truthOf(plan));
}

/// With several samples per pixel and an open shutter, beside a dynamic object, edges converge as well.
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
    RecordProperty("tested", std::to_string(first) + " " + std::to_string(fewest));
    EXPECT_LT(fewest, 0.25 * first);
    EXPECT_GT(fewest, 0.0);
}

/// Converged pixels keep their values, even if another technique has drawn into the frame's buffers since.
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

/// A lit object passes in front of a static shadow, and casts its own elsewhere: pixels that it enters or leaves are
/// right at once, though nothing moves between the shadow and the light.
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

/// The plan and the caches change nothing: neither a pixel's value nor when it is tested.
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
