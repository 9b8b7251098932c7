// After a reload of shaders nothing is drawn from what the old ones left behind: the same bytes as a cold start with
// the new ones, for every technique, with everything static and caches filled.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "frame/frame_renderer.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"
#include "support/shader_copy.h"
#include "techniques/registry.h"

namespace timeshade {
namespace {

/// Every lookup asks lib/receiver.glsl whether the receiver faces the light.
const std::vector<ShaderEdit> changedLookup{
    {"lib/receiver.glsl", "return inCone && ", "return inCone && gl_FragCoord.x > 30.0 && "}};
/// What builds share: the ordinary map, the stochastic rasteriser's samples of the light, and the lists of candidates.
const std::vector<ShaderEdit> changedBuild{
    {"passes/shadow_map.vert", "positionOpen, 1.0)", "positionOpen * 0.8, 1.0)"},
    {"passes/stochastic.frag", "pattern.xy = vec2(0.5);", "pattern.xy = vec2(0.5, 12.0);"},
    {"lib/candidate_cells.glsl", "void addToCell(SweptCaster c, ivec2 cell) {",
     "void addToCell(SweptCaster c, ivec2 cell) {\n    if (cell.x % 2 == 0) return;"}};

class Reload : public testing::TestWithParam<std::string> {
  protected:
    static constexpr int frames = 5;

    Reload() {
        request_.width = 64;
        request_.height = 48;
        request_.samplesPerPixel = 2;
        request_.mapSize = 64;
        request_.shutter.length = 0.0;  // nothing moves
    }

    std::unique_ptr<Technique> make(FrameRenderer& renderer) const {
        std::unique_ptr<Technique> technique = makeTechnique(GetParam(), renderer.programs());
        if (technique->renders() > 1) setFromText(*technique, "renders", "2");
        return technique;
    }

    std::vector<float> draw(FrameRenderer& renderer, Technique& technique) {
        for (int frame = 0; frame < frames; ++frame)
            renderer.draw(planner_.plan(request_), technique, View::Visibility);
        return renderer.readVisibility();
    }

    void expectLikeAColdStart(const std::vector<ShaderEdit>& edits) {
        const ShaderCopy shaders;
        FrameRenderer warm;
        const std::unique_ptr<Technique> technique = make(warm);
        const std::vector<float> before = draw(warm, *technique);
        for (const ShaderEdit& edit : edits) shaders.apply(edit);
        EXPECT_TRUE(warm.reloadShaders().empty());
        const std::vector<float> after = draw(warm, *technique);
        FrameRenderer cold;
        const std::unique_ptr<Technique> fresh = make(cold);
        EXPECT_EQ(after, draw(cold, *fresh));
        EXPECT_NE(after, before) << "the change makes no difference to this technique: the test tells nothing";
    }

    std::unique_ptr<ProceduralScene> scene_ = makeMovingScene({});
    FramePlanner planner_{*scene_};
    FrameRequest request_;
};

TEST_P(Reload, OfALookupShaderLeavesNothingBehind) { expectLikeAColdStart(changedLookup); }

TEST_P(Reload, OfABuildShaderLeavesNothingBehind) { expectLikeAColdStart(changedBuild); }

std::vector<std::string> names() {
    std::vector<std::string> all;
    for (const TechniqueDescription& description : techniqueDescriptions()) all.push_back(description.name);
    return all;
}

INSTANTIATE_TEST_SUITE_P(Techniques, Reload, testing::ValuesIn(names()), [](const auto& p) { return p.param; });

}  // namespace
}  // namespace timeshade
