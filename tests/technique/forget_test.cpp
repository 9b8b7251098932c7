// A technique forgets what it remembers of earlier frames when everything was invalidated since, and only then.
#include <gtest/gtest.h>

#include <optional>

#include "frame/frame_renderer.h"
#include "scene_catalogue.h"
#include "support/gl_environment.h"

namespace timeshade {
namespace {

/// Everything is lit; counts how often it was told to forget.
class CountingTechnique final : public Technique {
  public:
    int forgotten = 0;

    const TechniqueDescription& description() const override {
        static const TechniqueDescription description{"counting", "Counting", "Counting", "Counts.", "a test",
                                                      {},         {},         {},         {}};
        return description;
    }
    void visitSettings(SettingsVisitor&) override {}
    std::vector<PassDecision> passes(const FramePlan&) const override { return {}; }
    void forget() override { ++forgotten; }
    void build(const TechniqueFrame&) override {}
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame& frame) override {
        const float lit = 1.0f;
        glClearTexImage(frame.visibility.lit().name(), 0, GL_RED, GL_FLOAT, &lit);
    }
    std::size_t bytes() const override { return 0; }
};

class Forget : public testing::Test {
  protected:
    FramePlan plan(int width = 16) {
        FrameRequest request;
        request.width = width;
        request.height = 16;
        request.samplesPerPixel = 1;
        request.mapSize = 16;
        return planner_.plan(request);
    }

  private:
    const std::unique_ptr<Scene> scene_ = openScene("pillars", "");
    FramePlanner planner_{*scene_};
};

TEST_F(Forget, OnceAfterEachInvalidation) {
    FrameRenderer renderer;
    CountingTechnique technique;
    renderer.draw(plan(), technique, View::Final);
    renderer.draw(plan(), technique, View::Final);
    EXPECT_EQ(technique.forgotten, 0);
    renderer.invalidateAll();
    renderer.draw(plan(), technique, View::Final);
    renderer.draw(plan(), technique, View::Final);
    EXPECT_EQ(technique.forgotten, 1);
    renderer.draw(plan(24), technique, View::Final);
    EXPECT_EQ(technique.forgotten, 2) << "another size has other buffers";
}

/// Its address does not tell it from the one before.
TEST_F(Forget, ANewTechniqueInTheOldOnesPlaceHasNoPast) {
    FrameRenderer renderer;
    std::optional<CountingTechnique> technique;
    const CountingTechnique* before = &technique.emplace();
    renderer.draw(plan(), *technique, View::Final);
    technique.reset();
    renderer.invalidateAll();
    ASSERT_EQ(&technique.emplace(), before);
    renderer.draw(plan(), *technique, View::Final);
    EXPECT_EQ(technique->forgotten, 0);
}

TEST_F(Forget, WhatAnotherRendererHasInvalidatedSince) {
    FrameRenderer one, other;
    CountingTechnique technique, third;
    other.draw(plan(), third, View::Final);
    one.draw(plan(), technique, View::Final);
    other.draw(plan(), technique, View::Final);
    EXPECT_EQ(technique.forgotten, 0) << "swapped, and nothing has changed since it drew";
    one.draw(plan(), technique, View::Final);
    other.invalidateAll();
    other.draw(plan(), technique, View::Final);
    EXPECT_EQ(technique.forgotten, 1);
    one.draw(plan(), technique, View::Final);
    EXPECT_EQ(technique.forgotten, 1);
}

}  // namespace
}  // namespace timeshade
