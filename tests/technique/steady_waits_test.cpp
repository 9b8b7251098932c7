// What a sequence costs the processor in waits: none once it is under way, with any technique. Room for lists is then
// made before their length is known; where it did not suffice the frame says so, and is right when it is drawn again.
#include <gtest/gtest.h>

#include "gl/waits.h"
#include "support/gl_environment.h"
#include "support/has_setting.h"
#include "support/moving_scene.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

using Reading = gl::LateCounts::Reading;
using State = gl::LateCounts::State;

/// Every technique, and its published form where there is one.
std::vector<std::unique_ptr<Technique>> allForms() {
    std::vector<std::unique_ptr<Technique>> forms;
    for (const TechniqueDescription& description : techniqueDescriptions())
        for (const bool asPublished : {false, true}) {
            std::unique_ptr<Technique> technique = makeTechnique(description.name, sharedRenderer().programs());
            if (asPublished && !hasSetting(*technique, "as_published")) continue;
            if (asPublished) setFromText(*technique, "as_published", "on");
            if (technique->renders() > 1) setFromText(*technique, "renders", "3");
            forms.push_back(std::move(technique));
        }
    return forms;
}

void drawLater(const FramePlan& plan, Technique& technique) {
    sharedRenderer().begin(plan, technique, View::Final, {}, Reading::Later);
    while (!sharedRenderer().step()) {
    }
}

/// Buffers are not read back to be checked while it lives.
struct Unchecked {
    Unchecked() { sharedRenderer().setChecked(false); }
    ~Unchecked() { sharedRenderer().setChecked(true); }
    Unchecked(const Unchecked&) = delete;
    Unchecked& operator=(const Unchecked&) = delete;
};

TEST(SteadyFrames, WaitForNothing) {
    const Unchecked unchecked;
    const std::unique_ptr<ProceduralScene> scene = makeMovingScene({.quads = 40, .seed = 4});
    FramePlanner planner(*scene);
    for (const std::unique_ptr<Technique>& technique : allForms()) {
        const std::string& name = technique->description().name;
        for (int frame = 0; frame < 5; ++frame) {
            FrameRequest request = ProceduralScene::request(24, 18, 2, 32, 4);
            request.frame = 0.1 * frame;
            const FramePlan plan = planner.plan(technique->asked(request));
            if (technique->unsupported(plan)) break;
            const std::uint64_t before = gl::waitsSoFar();
            drawLater(plan, *technique);
            const std::uint64_t waits = gl::waitsSoFar() - before;
            EXPECT_EQ(frame > 2 ? waits : 0, 0u) << name << ", frame " << frame;
            EXPECT_EQ(sharedRenderer().settledRoom(), State::Sufficed) << name << ", frame " << frame;
        }
    }
}

TEST(SteadyFrames, SayWhereListsHadNoRoom) {
    const Unchecked unchecked;
    const std::unique_ptr<ProceduralScene> few = makeMovingScene({.quads = 3, .seed = 4}),
                                           many = makeMovingScene({.quads = 300, .seed = 4});
    FramePlanner fewPlanner(*few), manyPlanner(*many);
    FramePlan small = fewPlanner.plan(ProceduralScene::request(24, 18, 2, 48, 4)),
              large = manyPlanner.plan(ProceduralScene::request(24, 18, 2, 48, 4));
    int outgrown = 0;
    for (const std::unique_ptr<Technique>& technique : allForms()) {
        const std::string& name = technique->description().name;
        // Grids that a cost model chooses differ between the two, and are counted anew.
        if (hasSetting(*technique, "side")) setFromText(*technique, "side", "32");
        if (hasSetting(*technique, "buckets")) setFromText(*technique, "buckets", "4");
        technique->forget();
        sharedRenderer().draw(large, *technique, View::Visibility);
        const std::vector<float> right = sharedRenderer().readVisibility();
        const std::unique_ptr<Technique> fresh = makeTechnique(name, sharedRenderer().programs());
        for (const Setting& setting : settingsOf(*technique)) setFromText(*fresh, setting.key, textOf(setting));
        for (int i = 0; i < 2; ++i) drawLater(small, *fresh);
        EXPECT_EQ(sharedRenderer().settledRoom(), State::Sufficed) << name;
        fresh->forget();
        drawLater(large, *fresh);
        if (sharedRenderer().settledRoom() == State::TooMany) {
            ++outgrown;
            drawLater(large, *fresh);
        }
        EXPECT_EQ(sharedRenderer().settledRoom(), State::Sufficed) << name;
        EXPECT_EQ(sharedRenderer().readVisibility(), right) << name;
    }
    EXPECT_GE(outgrown, 8) << "forms with lists";
}

}  // namespace
}  // namespace timeshade
