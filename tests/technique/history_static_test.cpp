// The technique `history` while nothing moves: it converges to the oracle's hard shadow, and stays there.
#include <algorithm>
#include <array>
#include <numeric>

#include <gtest/gtest.h>

#include "cases/closed_form_cases.h"
#include "technique/history_scenes.h"

namespace timeshade {
namespace {

/// From an empty history, with a static camera.
TEST(HistoryStatic, ConvergesToTheOraclesHardShadow) {
    const auto scene = boardScene();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(256, 192, 96));
    const std::vector<float> truth = truthOf(plan);
    const auto errorsOf = [&](const std::vector<std::pair<const char*, const char*>>& settings) {
        const auto technique = makeHistory();
        for (const auto& [key, value] : settings) setFromText(*technique, key, value);
        std::vector<double> errors;
        for (int frame = 1; frame <= 60; ++frame) errors.push_back(meanDifference(drawnLit(plan, *technique), truth));
        return errors;
    };
    const std::vector<double> repaired = errorsOf({});
    RecordProperty("after_1_20_60", std::to_string(repaired[0]) + " " + std::to_string(repaired[19]) + " " +
                                        std::to_string(repaired[59]));
    EXPECT_LT(repaired[19], 0.25 * repaired[0]);
    EXPECT_LT(repaired[59], 0.15 * repaired[0]);
    // About 20 pixels of an edge are not sure at the end: one or two may be wrong for some frames.
    const std::array<std::size_t, 6> shown{0, 4, 9, 19, 39, 59};
    for (std::size_t i = 1; i < shown.size(); ++i) EXPECT_LT(repaired[shown[i]], repaired[shown[i - 1]] + 1e-4);
    // The published form does not converge: exponential smoothing forgets older frames.
    const std::vector<double> published = errorsOf({{"as_published", "on"}, {"published_bias", "0.5"}});
    EXPECT_GT(published[59], 2.0 * repaired[59]);
}

/// All three fits and rasters show the same shadow.
TEST(HistoryStatic, EveryFitConverges) {
    const auto scene = boardScene();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(96, 72, 64));
    const std::vector<float> truth = truthOf(plan);
    for (const char* fit : {"0", "1", "2"})
        for (const char* jitter : {"1", "2"}) {
            const auto technique = makeHistory();
            setFromText(*technique, "fit", fit);
            setFromText(*technique, "jitter", jitter);
            const double first = meanDifference(drawnLit(plan, *technique), truth);
            for (int frame = 2; frame < 40; ++frame) drawnLit(plan, *technique);
            EXPECT_LT(meanDifference(drawnLit(plan, *technique), truth), std::max(0.3 * first, 1e-3))
                << "fit " << fit << ", jitter " << jitter;
        }
}

/// A frame that is held with the shutter open converges to the lit share of the shutter, which one map does not hold.
TEST(HistoryStatic, BlurredShadowsConvergeToTheirShare) {
    for (const char* name : {"quad_sweeps_point", "light_slides"}) {
        const ClosedFormCase& c = closedFormCase(name);
        const auto technique = makeHistory();
        const FramePlan plan = FramePlanner(*c.scene).plan(ProceduralScene::request(4, 32, 4, 512, 3));
        std::vector<float> lit;
        for (int frame = 0; frame < 100; ++frame) lit = drawnLit(plan, *technique);
        const double mean = std::accumulate(lit.begin(), lit.end(), 0.0) / static_cast<double>(lit.size());
        EXPECT_NEAR(mean, c.exact, 0.03) << name;  // 100 instants, weighted by 1 to 7 effective tests a texel
    }
}

/// A caster's edge is exact from the first frame on, however coarse the map: its triangle is tested against each
/// pixel's own segment to the light.
TEST(HistoryStatic, EdgesAreSharpAtOnce) {
    const auto scene = boardScene();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(160, 120, 64));
    const std::vector<float> truth = truthOf(plan);
    const auto technique = makeHistory(), jittered = makeJitteredMap();
    const double first = meanDifference(drawnLit(plan, *technique), truth);
    EXPECT_LT(first, 0.05 * meanDifference(drawnLit(plan, *jittered), truth));
    for (int frame = 2; frame < 20; ++frame) drawnLit(plan, *technique);
    RecordProperty("after 1, 20",
                   std::to_string(first) + " " + std::to_string(meanDifference(drawnLit(plan, *technique), truth)));
    EXPECT_EQ(meanDifference(drawnLit(plan, *technique), truth), 0.0);
}

/// Sums in float must not drift: after 10,000 frames of a constant scene lit pixels are lit, shadowed ones shadowed,
/// and the edge has not moved. A distant object moves all the time, or the picture would have converged after 64
/// frames.
TEST(HistoryStatic, DoesNotDriftInTenThousandFrames) {
    const auto scene = boardScene();
    scene->quads.push_back(slidingQuad({0.0, 0.0, -50.0}, {16.0, 0.0, -50.0}, 0.1, -0.1, 0.1));
    scene->finish();
    FramePlanner planner(*scene);
    FrameRequest request = staticRequest(8, 6, 16);
    request.shutter.framesPerSecond =
        16384.0;  // shares of a second that floats hold exactly, or the light would tremble
    request.cameraPose = scene->cameraOpen;
    const std::vector<float> truth = truthOf(planner.plan(request));
    FrameRenderer renderer;  // unchecked: reading everything back each time would take minutes
    HistoryShadow technique(renderer.programs());
    std::vector<double> errors;
    for (int frame = 1; frame <= 10000; ++frame, request.frame += 1.0) {
        renderer.draw(planner.plan(request), technique, View::Visibility);
        if (frame == 10 || frame == 1000 || frame == 10000)
            errors.push_back(meanDifference(renderer.readVisibility(), truth));
    }
    EXPECT_LE(errors[1], errors[0] + 1e-6);
    EXPECT_LE(errors[2], errors[1] + 1e-6);
    EXPECT_LT(errors[2], 0.01);
    EXPECT_EQ(technique.statistics().front().value, 9999.0) << "frames with a static camera";
}

TEST(HistoryMemory, IsWhatWasPredicted) {
    const auto scene = boardScene();
    const auto technique = makeHistory();
    const FramePlan plan = FramePlanner(*scene).plan(staticRequest(64, 48, 128));
    drawnLit(plan, *technique);
    // Two buffers of 16 bytes per pixel, the map's depths and triangles, the uniforms; nothing moves, so there is
    // neither mask nor older mesh.
    const std::size_t first = std::size_t{2 * 16 * 64 * 48 + (4 + 4) * 128 * 128} + sizeof(shared::HistoryBlock);
    EXPECT_EQ(technique->bytes(), first);
    // With a static camera pixels may converge: 8 bytes per pixel, and 4 per sample.
    drawnLit(plan, *technique);
    EXPECT_EQ(technique->bytes(), first + std::size_t{(8 + 4) * 64 * 48});
}

}  // namespace
}  // namespace timeshade
