// The technique `history` never shows an invalid or broken history.
#include <limits>
#include <utility>

#include <gtest/gtest.h>

#include "technique/history_scenes.h"

namespace timeshade {
namespace {

void fill(const gl::Texture& texture, const glm::vec4& value) {
    glClearTexImage(texture.name(), 0, GL_RGBA, GL_FLOAT, &value.x);
}

/// Case 35: implausible values in the history are ignored.
TEST(HistoryBroken, NothingThatIsNoNumberSurvives) {
    const auto scene = boardScene({}, {0.01, 0.0, 0.0});
    FramePlanner planner(*scene);
    constexpr float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    for (const bool published : {false, true})
        for (const auto& [step, frames] :
             {std::pair(0.0, 3), std::pair(0.0, 20),
              std::pair(1.0, 3)}) {  // held; until pixels converge; with a camera that moves
            const auto after = [&](const glm::vec4& poison) {
                const auto technique = makeHistory();
                setFromText(*technique, "as_published", published ? "on" : "off");
                FrameRequest request = staticRequest(24, 18, 32);
                for (int frame = 0; frame < frames; ++frame, request.frame += step)
                    drawnLit(planner.plan(request), *technique);
                fill(technique->written(), poison);
                return drawnLit(planner.plan(request), *technique);
            };
            const std::vector<float> clean = after(glm::vec4(0.0f));
            for (const glm::vec4& poison :
                 {glm::vec4(nan), glm::vec4(nan, 1.0f, 1.0f, 32.0f), glm::vec4(1.0f, nan, 1.0f, 32.0f),
                  glm::vec4(1.0f, 1.0f, nan, 32.0f), glm::vec4(1.0f, 1.0f, 1.0f, nan), glm::vec4(infinity),
                  glm::vec4(-1.0f, 1.0f, 1.0f, 32.0f), glm::vec4(2.0f, 1.0f, 1.0f, 32.0f),
                  glm::vec4(1.0f, infinity, 1.0f, 32.0f)})
                EXPECT_EQ(after(poison), clean)
                    << poison.x << " " << poison.y << " " << poison.z << " " << poison.w << " step " << step;
        }
}

/// After a camera cut the picture equals that of this frame's tests alone.
TEST(HistoryBroken, ATeleportedCameraHasNoPast) {
    const auto scene = boardScene();
    FramePlanner planner(*scene);
    const auto technique = makeHistory(), other = makeHistory();
    FrameRequest request = staticRequest(24, 18, 32);
    FrameRequest elsewhere = request;
    elsewhere.cameraPose = scene->cameraOpen;
    elsewhere.cameraPose->eye += glm::dvec3(-3.0, 2.0, 0.5);
    for (int frame = 0; frame < 5; ++frame)
        for (HistoryShadow* one : {technique.get(), other.get()}) drawnLit(planner.plan(elsewhere), *one);
    fill(other->written(), glm::vec4(0.0f));
    EXPECT_EQ(drawnLit(planner.plan(request), *technique), drawnLit(planner.plan(request), *other));
}

TEST(HistoryBroken, EverySizeBeginsAnew) {
    const auto scene = boardScene();
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    for (int frame = 0; frame < 12; ++frame) {
        FrameRequest request = staticRequest(16 + 5 * (frame % 4), 12 + 3 * (frame % 3), 32);
        request.frame = frame;
        const std::vector<float> lit = drawnLit(planner.plan(request), *technique);
        EXPECT_EQ(lit, drawnLit(planner.plan(request), *makeHistory())) << "frame " << frame;
    }
}

TEST(HistoryBroken, ScrubbingAndSettingsBeginAnew) {
    const auto scene = boardScene();
    FramePlanner planner(*scene);
    const auto technique = makeHistory();
    FrameRequest request = staticRequest(24, 18, 32);
    const auto equalsFresh = [&] {
        return drawnLit(planner.plan(request), *technique) == drawnLit(planner.plan(request), *makeHistory());
    };
    for (request.frame = 5.0; request.frame < 9.0; request.frame += 1.0) drawnLit(planner.plan(request), *technique);
    EXPECT_FALSE(equalsFresh()) << "the history has no effect, so the test shows nothing";
    request.frame = 2.0;
    EXPECT_TRUE(equalsFresh()) << "back";
    request.frame = 40.0;
    EXPECT_TRUE(equalsFresh()) << "far ahead";
    drawnLit(planner.plan(request), *technique);
    request.seed = 2;
    EXPECT_TRUE(equalsFresh()) << "another seed";
    drawnLit(planner.plan(request), *technique);
    technique->forget();
    EXPECT_TRUE(equalsFresh()) << "after a reset";
}

}  // namespace
}  // namespace timeshade
