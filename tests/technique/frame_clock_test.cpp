// Honest clocks: no timed frame compiles a program, every frame is in the state that it is said to be in, and the frame
// that remains is the one that any other command draws.
#include <gtest/gtest.h>

#include "frame/warm_up.h"
#include "measure/frame_clock.h"
#include "scene_catalogue.h"
#include "support/drawn_here.h"
#include "support/gl_environment.h"
#include "support/no_drawing.h"
#include "support/thorough.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

FrameRequest smallRequest() {
    FrameRequest request;
    request.width = 48;
    request.height = 32;
    request.samplesPerPixel = 4;
    request.mapSize = 64;
    request.frame = 20.0;
    request.shutter.length = 0.5;
    request.shutter.framesPerSecond = 24.0;
    return request;
}

class Clocks : public DrawnHere<std::string> {
  protected:
    std::unique_ptr<Technique> make(FrameRenderer& renderer) const {
        std::unique_ptr<Technique> technique = makeTechnique(GetParam(), renderer.programs());
        if (technique->renders() > 1) setFromText(*technique, "renders", "4");
        return technique;
    }
};

TEST_P(Clocks, NoTimedFrameCompiles) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FrameRenderer renderer;
    FramePlanner planner(*scene);
    const std::unique_ptr<Technique> technique = make(renderer);
    FrameClock clock(renderer, planner, View::Final);
    EXPECT_EQ(renderer.programs().compiled(), 0u);
    clock.warmUp(*technique, smallRequest(), 2);
    const std::uint64_t compiled = renderer.programs().compiled();
    EXPECT_GE(compiled, 3u) << "sample, lookup and shade at least";
    FrameRequest request = smallRequest();
    for (const std::uint32_t seed : {1u, 2u}) {
        request.seed = seed;
        const std::vector<ClockedFrame> frames = clock.time(*technique, request, 2);
        EXPECT_EQ(frames.front().state, FrameState::Cold);
        EXPECT_EQ(frames.back().state, FrameState::Steady);
        EXPECT_EQ(frames.size(), warmUpCount(*technique) == 0 && technique->renders() == 1 ? 4u : 3u);
        for (const ClockedFrame& frame : frames) EXPECT_GT(gl::totalOf(frame.readings), 0.0);
    }
    EXPECT_EQ(renderer.programs().compiled(), compiled);
}

TEST_P(Clocks, LeavesTheFrameAsAnyOtherCommandDrawsIt) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FrameRenderer& renderer = sharedRenderer();
    FramePlanner planner(*scene);
    const FrameRequest request = smallRequest();
    const std::unique_ptr<Technique> technique = make(renderer);
    drawWarmUp(renderer, planner, *technique, request, View::Final);
    renderer.draw(planner.plan(request), *technique, View::Final);
    const std::vector<float> wanted = renderer.readRadiance().rgb;
    const std::unique_ptr<Technique> timed = make(renderer);
    FrameClock clock(renderer, planner, View::Final);
    clock.time(*timed, request, 2);
    EXPECT_TRUE(renderer.readRadiance().rgb == wanted);
    EXPECT_EQ(renderer.plan().request.frame, request.frame);
}

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const TechniqueDescription& description : techniqueDescriptions()) all.push_back(description.name);
    return all;
}

INSTANTIATE_TEST_SUITE_P(All, Clocks, testing::ValuesIn(names()), [](const auto& p) { return p.param; });

TEST(FrameClock, TimesAgainWhatWasCompiledInATimedFrame) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FrameRenderer renderer;
    FramePlanner planner(*scene);
    const std::unique_ptr<Technique> technique = makeTechnique(names().front(), renderer.programs());
    FrameClock clock(renderer, planner, View::Final);
    clock.warmUp(*technique, smallRequest(), 2);
    renderer.programs().keepNewest(0);  // as other techniques' programs would have it
    const std::uint64_t before = renderer.programs().compiled();
    EXPECT_EQ(clock.time(*technique, smallRequest(), 1).size(), 3u);
    const std::uint64_t after = renderer.programs().compiled();
    EXPECT_GT(after, before);
    clock.time(*technique, smallRequest(), 1);
    EXPECT_EQ(renderer.programs().compiled(), after);
}

/// A sweep goes through the techniques of one scene round after round, then through those of the next.
TEST(FrameClock, ProgramsOfAllTechniquesInASceneAreCompiledOnce) {
    const NoDrawing linkingIsEnough;
    FrameRenderer renderer;
    const std::vector<BuiltInScene>& scenes = builtInScenes();
    for (std::size_t i = 0; i < scenes.size(); i += usualOrAll<std::size_t>(9, 1)) {
        const std::unique_ptr<Scene> scene = openScene(scenes[i].name, "",
                                                       {{"cubes.count", "50"},
                                                        {"frusta.rows", "4"},
                                                        {"leg.cell", "20"},
                                                        {"runner.cell", "20"},
                                                        {"tree.sprays", "20"},
                                                        {"octopus-fine.triangles", "80000"}});
        FramePlanner planner(*scene);
        FrameClock clock(renderer, planner, View::Final);
        const auto drawAll = [&] {
            for (const std::string& name : names())
                clock.warmUp(*makeTechnique(name, renderer.programs()), smallRequest(), 2);
            return renderer.programs().compiled();
        };
        const std::uint64_t once = drawAll();
        EXPECT_EQ(drawAll(), once) << "of " << scenes[i].name << " some were dropped in between";
    }
}

/// Caches are full in the last of several frames of a sequence, and hold nothing once they have been emptied.
TEST(FrameClock, CachesThatAreEmptiedHoldNothing) {
    const std::unique_ptr<Scene> scene = openScene("chess", "");
    FrameRenderer renderer;
    FramePlanner planner(*scene);
    const FrameRequest request = smallRequest();
    const std::unique_ptr<Technique> technique = makeTechnique(names().front(), renderer.programs());
    renderer.draw(planner.plan(request), *technique, View::Final);
    const std::size_t once = renderer.memory().total();
    for (int i = 0; i < 3; ++i) renderer.draw(planner.plan(request), *technique, View::Final);
    ASSERT_GT(renderer.memory().total(), once) << "a scene in which nothing is cached tells nothing";
    emptyCaches(renderer, *technique);
    EXPECT_LE(renderer.memory().total(), once);
}

TEST(FrameClock, StatesHaveNames) {
    for (const FrameState state : {FrameState::Cold, FrameState::Filling, FrameState::Steady})
        EXPECT_EQ(frameStateNamed(nameOf(state)), state);
    EXPECT_FALSE(frameStateNamed("warm"));
}

}  // namespace
}  // namespace timeshade
