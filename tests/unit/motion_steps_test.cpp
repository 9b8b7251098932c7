// What the plan says of a shutter that is cut into linear pieces: samples, weights, jumps, warnings.

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "../broken_gltf/gltf_writer.h"
#include "cases/closed_form_cases.h"
#include "plan/frame_plan.h"
#include "scene/gltf_scene.h"
#include "shared/sample_pattern.shared.h"
#include "shared/shutter_response.shared.h"
#include "support/spinning_cube.h"

namespace timeshade {
namespace {

using namespace test;

FrameRequest requestOf(int samples, int steps) {
    FrameRequest request = ProceduralScene::request(200, 150, samples, 512, 1);
    request.motionSteps = steps;
    return request;
}

TEST(MotionSteps, PiecesHaveTheSamplesOfTheWhole) {
    const std::shared_ptr<ProceduralScene> scene = closedFormCase("quad_sweeps_point").scene;
    const shared::FrameBlock whole = FramePlanner(*scene).plan(requestOf(12, 1)).block;
    EXPECT_EQ(whole.firstStratum, 0u);
    const FramePlan plan = FramePlanner(*scene).plan(requestOf(12, 4));
    ASSERT_EQ(plan.pieces.size(), 4u);
    EXPECT_EQ(plan.block.strata, 12u);
    for (std::uint32_t k = 0; k < 12; ++k) {
        const shared::FrameBlock& block = plan.pieces[k / 3].block;
        ASSERT_EQ(block.strata, 3u);
        const auto timeOf = [&](const shared::FrameBlock& b, std::uint32_t stratum) {
            const float xi = shared::samplePattern({5, 7}, b.firstStratum + stratum, b.seed, SALT_CAMERA).z;
            return shared::sampleTime(b.timeBase, b.timeScale, stratum, xi);
        };
        const float u = timeOf(block, k % 3), expected = timeOf(whole, k);
        EXPECT_NEAR((static_cast<float>(k / 3) + u) / 4.0f, expected, 1e-6f);
    }
}

TEST(MotionSteps, NeighboursMeet) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();
    const FramePlan plan = FramePlanner(*cube).plan(requestOf(8, 8));
    for (std::size_t k = 0; k + 1 < plan.pieces.size(); ++k)
        EXPECT_EQ(plan.pieces[k].mesh->positionsClose, plan.pieces[k + 1].mesh->positionsOpen);
    const FramePlan whole = FramePlanner(*cube).plan(requestOf(8, 1));
    EXPECT_EQ(plan.pieces.front().mesh->positionsOpen, whole.mesh->positionsOpen);
    EXPECT_EQ(plan.pieces.back().mesh->positionsClose, whole.mesh->positionsClose);
}

TEST(MotionSteps, AreLoweredToWhatDividesTheSamples) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();
    struct Case {
        int samples, asked, drawn;
    };
    for (const auto& [samples, asked, drawn] :
         std::vector<Case>{{8, 8, 8}, {8, 16, 8}, {12, 8, 4}, {7, 2, 1}, {32, 32, 32}, {1, 32, 1}, {24, 16, 8}}) {
        const FramePlan plan = FramePlanner(*cube).plan(requestOf(samples, asked));
        EXPECT_EQ(plan.pieces.size(), drawn == 1 ? 0u : static_cast<std::size_t>(drawn));
        const std::string said = "motion steps: " + std::to_string(drawn) + " instead of " + std::to_string(asked);
        const bool isSaid = std::any_of(plan.warnings.begin(), plan.warnings.end(),
                                        [&](const std::string& w) { return w.starts_with(said); });
        EXPECT_EQ(isSaid, drawn != asked) << samples << " samples, " << asked << " steps";
    }
    FrameRequest closed = requestOf(8, 8);
    closed.shutter.length = 0.0;
    EXPECT_TRUE(FramePlanner(*cube).plan(closed).pieces.empty());
    EXPECT_TRUE(FramePlanner(*cube).plan(closed).warnings.empty());
}

TEST(MotionSteps, WarningsVanishWhenTheStepsSuffice) {
    const std::unique_ptr<Scene> cube = makeSpinningCube();
    double before = 1e9;
    for (const int steps : {1, 2, 4, 8, 16, 32}) {
        FrameRequest request = requestOf(32, steps);
        const std::vector<PathWarning> warnings = FramePlanner(*cube).plan(request).pathWarnings;
        if (steps == 32) {
            EXPECT_TRUE(warnings.empty()) << warnings.front().text;
            continue;
        }
        if (warnings.empty()) continue;
        ASSERT_EQ(warnings.size(), 1u);
        EXPECT_NE(warnings[0].text.find("leaves the straight path"), std::string::npos);
        EXPECT_EQ(warnings[0].text.starts_with("piece "), steps > 1) << warnings[0].text;
        EXPECT_LT(warnings[0].size, steps == 2 ? before : 0.35 * before) << "a quarter with each doubling";
        before = warnings[0].size;
    }
}

TEST(MotionSteps, WeightsOfPiecesMakeOneWhole) {
    const std::shared_ptr<ProceduralScene> scene = closedFormCase("quad_sweeps_point").scene;
    for (const auto response : {ShutterResponse::Box, ShutterResponse::Tent, ShutterResponse::Gaussian}) {
        FrameRequest request = requestOf(8, 1);
        request.shutter.response = response;
        const shared::FrameBlock whole = FramePlanner(*scene).plan(request).block;
        request.motionSteps = 8;
        const FramePlan plan = FramePlanner(*scene).plan(request);
        float sum = 0.0f;
        for (std::size_t k = 0; k < 8; ++k) {
            const shared::FrameBlock& piece = plan.pieces[k].block;
            sum += piece.weight;
            for (const float u : {0.0f, 0.3f, 1.0f}) {
                const float t = (static_cast<float>(k) + u) / 8.0f;
                EXPECT_EQ(shared::shutterWeight(piece.response, piece.responseWidth, u),
                          shared::shutterWeight(whole.response, whole.responseWidth, t));
                if (response == ShutterResponse::Box) continue;
                EXPECT_EQ(shared::shutterExposure(piece.response, piece.responseWidth, u),
                          shared::shutterExposure(whole.response, whole.responseWidth, t));
            }
        }
        EXPECT_NEAR(sum, 1.0f, 1e-6f);
        float renders = 0.0f;
        for (int m = 0; m < 24; ++m) {
            const shared::FrameBlock block = planAtInstant(plan, m, 24).block;
            renders += block.weight;
            EXPECT_NEAR(block.timeBase, std::fmod((static_cast<float>(m) + 0.5f) / 3.0f, 1.0f), 1e-5f) << m;
        }
        EXPECT_NEAR(renders, 1.0f, 1e-6f);
    }
}

/// A response counts also in a piece in which nothing moves.
TEST(MotionSteps, OneMovingPieceIsEnoughForAResponse) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    file.animate(0, "translation", {0, 0.75f, 1}, file.vec3s({0, 0, 0, 0, 0, 0, 1, 0, 0}));
    const TemporaryFolder folder;
    const auto scene = loadGltf(folder.write("late.glb", file.glb()));
    FrameRequest request = requestOf(8, 4);
    request.shutter.response = ShutterResponse::Tent;
    const FramePlan plan = FramePlanner(*scene).plan(request);
    EXPECT_EQ(plan.pieces[0].motion.movingTriangles, 0u);
    EXPECT_GT(plan.pieces[3].motion.movingTriangles, 0u);
    EXPECT_GT(plan.motion.movingTriangles, 0u);
    for (const FramePlan& piece : plan.pieces) EXPECT_EQ(piece.block.response & SHUTTER_KIND, SHUTTER_TENT);
}

/// A jump is moved to an end of its own piece.
TEST(MotionSteps, AJumpIsInOnePiece) {
    GltfFile file;
    addQuad(file);
    file.addRoot({{"mesh", 0}});
    file.animate(0, "translation", {0, 0.3f, 1}, file.vec3s({0, 0, 0, 4, 0, 0, 4, 0, 0}), "STEP");
    const TemporaryFolder folder;
    const auto scene = loadGltf(folder.write("jump.glb", file.glb()));
    const FramePlan plan = FramePlanner(*scene).plan(requestOf(8, 8));
    ASSERT_EQ(plan.pieces.size(), 8u);
    for (std::size_t k = 0; k < 8; ++k) {
        EXPECT_EQ(plan.pieces[k].mesh->positionsOpen, plan.pieces[k].mesh->positionsClose) << k;
        // The key lies in piece 2, before its middle.
        EXPECT_EQ(plan.pieces[k].mesh->positionsOpen[0].x > 3.0, k >= 2) << k;
    }
}

}  // namespace
}  // namespace timeshade
