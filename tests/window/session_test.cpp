// What the window's session and its frames do, with OpenGL and without a display.

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/pause.h"
#include "random_hand.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"
#include "techniques/registry.h"
#include "window/drawing_state.h"
#include "window/session.h"
#include "window/settings_io.h"
#include "window/slices.h"

namespace timeshade {
namespace {

/// Leaves OpenGL as a window's frame does.
void disturb() {
    const DrawingState state;
    const GLboolean blended = glIsEnabled(GL_BLEND);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, 3, 3);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glDisable(GL_DEPTH_TEST);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glUseProgram(0);
    if (blended == GL_FALSE) glDisable(GL_BLEND);
}

struct SmallFrame {
    std::unique_ptr<Scene> scene = openScene("pillars", "");
    FramePlanner planner{*scene};
    FramePlan plan(double shutter, double frame = 12.0) {
        FrameRequest request;
        request.width = 48;
        request.height = 36;
        request.samplesPerPixel = 2;
        request.mapSize = 64;
        request.frame = frame;
        request.shutter.length = shutter;
        return planner.plan(request);
    }
};

TEST(SlicedFrame, IsTheSamePictureForEveryTechnique) {
    SmallFrame small;
    FrameRenderer& renderer = sharedRenderer();
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        const auto picture = [&](Slices* slices) {
            const std::unique_ptr<Technique> technique = makeTechnique(description.name, renderer.programs());
            for (Setting& setting : settingsOf(*technique))
                if (setting.key == "renders") setting.set(3.0);
            renderer.invalidateAll();
            std::optional<Slices::Work> work;
            if (slices != nullptr) work.emplace(*slices);
            // Twice: what is cached is drawn in slices too.
            for (int i = 0; i < 2; ++i) renderer.draw(small.plan(0.5), *technique, View::Final);
            return renderer.readRadiance().rgb;
        };
        Slices slices(
            disturb, [] { return false; }, std::chrono::milliseconds(0));
        const std::vector<float> whole = picture(nullptr);
        EXPECT_EQ(whole == picture(&slices), true) << description.name;
        EXPECT_GT(slices.ended(), 3) << description.name;
    }
}

/// Draws another frame, so that no buffer holds what it should by chance, then the frame twice, which it leaves at that
/// pause. False where there are not so many.
bool leaveAt(int last, const FramePlan& other, const FramePlan& plan, Technique& technique) {
    const Slices* own = nullptr;
    Slices slices([] {}, [&] { return own->ended() == last; }, std::chrono::milliseconds(0));
    own = &slices;
    technique.forget();
    sharedRenderer().invalidateAll();
    sharedRenderer().draw(other, technique, View::Final);
    technique.forget();
    try {
        const Slices::Work work(slices);
        for (int i = 0; i < 2; ++i) sharedRenderer().draw(plan, technique, View::Final);
    } catch (const WorkCancelled&) {
        EXPECT_EQ(slices.ended(), last) << "nothing goes on after the slice";
        return true;
    }
    return false;
}

TEST(SlicedFrame, CanBeLeftAnywhereAndDrawnAgain) {
    SmallFrame small;
    FrameRenderer& renderer = sharedRenderer();
    for (const double shutter : {small.scene->defaults().shutterLength, 0.0}) {
        const FramePlan other = small.plan(shutter, 30.0), plan = small.plan(shutter);
        for (const TechniqueDescription& description : techniqueDescriptions()) {
            const std::unique_ptr<Technique> technique = makeTechnique(description.name, renderer.programs());
            if (technique->renders() > 1) continue;  // many of one kind
            renderer.invalidateAll();
            renderer.draw(plan, *technique, View::Final);
            const std::vector<float> whole = renderer.readRadiance().rgb;
            for (int last = 1; leaveAt(last, other, plan, *technique); last *= 4) {
                renderer.draw(plan, *technique, View::Final);
                ASSERT_EQ(whole == renderer.readRadiance().rgb, true)
                    << description.name << " with a shutter of " << shutter << ", left at " << last;
            }
        }
    }
}

PictureOptions smallOptions() {
    PictureOptions options;
    options.scene = "pillars";
    options.settings = {{"cubes.count", "20"}};
    return options;
}

TEST(Undo, FiveHundredChangesAndBack) {
    const PictureOptions options = smallOptions();
    Session session(options, openScene(options.scene, "", options.settings), "test");
    session.keepForUndo();
    std::vector<std::string> states{settingsText(session)};
    RandomHand hand(session, 7);
    for (int i = 0; i < 500; ++i) {
        hand.change();
        session.keepForUndo();
        if (const std::string now = settingsText(session); now != states.back()) states.push_back(now);
    }
    ASSERT_GT(states.size(), 300u);
    ASSERT_EQ(session.undo.undoable(), states.size() - 1);
    const auto go = [&](bool back) {
        (back ? session.requests.undo : session.requests.redo) = true;
        session.applyRequests();
        session.keepForUndo();
    };
    for (std::size_t i = states.size() - 1; i-- > 0;) {
        go(true);
        ASSERT_EQ(settingsText(session), states[i]) << "step " << i;
    }
    for (std::size_t i = 1; i < states.size(); ++i) {
        go(false);
        ASSERT_EQ(settingsText(session), states[i]) << "step " << i;
    }
    EXPECT_EQ(session.undo.redoable(), 0u);
}

TEST(Session, AnotherSceneLeavesTheInstant) {
    const PictureOptions options = smallOptions();
    Session session(options, openScene(options.scene, "", options.settings), "test");
    session.moment.instant = 0.25;
    session.requests.scene = "cubes";
    session.applyRequests();
    EXPECT_EQ(session.scene.name(), "cubes");
    EXPECT_FALSE(session.moment.instant);
}

}  // namespace
}  // namespace timeshade
