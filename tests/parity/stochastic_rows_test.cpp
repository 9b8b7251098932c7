// Layers of moving triangles that are drawn some rows at a time hold, bit for bit, what the whole ones do.
#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "passes/stochastic_rasterizer.h"
#include "support/gl_environment.h"
#include "support/moving_scene.h"

namespace timeshade {
namespace {

constexpr MapSize mapSize(48, 37);
constexpr int strata = 3;

/// Draws the dynamic casters of a frame whole and in parts of a few rows.
class RowsTechnique final : public Technique {
  public:
    const TechniqueDescription& description() const override {
        static const TechniqueDescription description{"rows", "Rows", "Rows", "", "a test", {}, {}, {}, {}};
        return description;
    }
    void visitSettings(SettingsVisitor&) override {}
    std::vector<PassDecision> passes(const FramePlan&) const override { return {}; }
    void build(const TechniqueFrame& frame) override {
        StochasticRasterizer rasterizer(sharedRenderer().programs());
        whole = drawn(rasterizer, frame, mapSize.height, 0);
        constexpr int rows = 10;  // the last part reaches beyond the map
        for (int first = 0; first < mapSize.height; first += rows) {
            const std::vector<float> some = drawn(rasterizer, frame, rows, first);
            const auto perRow = static_cast<std::size_t>(mapSize.width);
            for (std::size_t layer = 0; layer < strata; ++layer)
                for (std::size_t row = 0; row < rows; ++row) {
                    const auto part = some.begin() + static_cast<std::ptrdiff_t>((layer * rows + row) * perRow);
                    const std::size_t y = static_cast<std::size_t>(first) + row;
                    const std::size_t same = (layer * static_cast<std::size_t>(mapSize.height) + y) * perRow;
                    for (std::size_t x = 0; x < perRow; ++x) {
                        const float expected = y < static_cast<std::size_t>(mapSize.height) ? whole[same + x] : 0.0f;
                        different += part[static_cast<std::ptrdiff_t>(x)] != expected ? 1u : 0u;
                    }
                }
        }
    }
    LookupProgram lookupProgram(const TechniqueFrame&, Casters) override { return {}; }
    bool hasOwnLookup() const override { return true; }
    void drawLookup(const TechniqueFrame&) override {}
    std::size_t bytes() const override { return 0; }

    std::vector<float> whole;
    std::size_t different = 0;

  private:
    static std::vector<float> drawn(StochasticRasterizer& rasterizer, const TechniqueFrame& frame, int rows,
                                    int firstRow) {
        const gl::Texture depth = gl::Texture::array2D("rows", GL_DEPTH_COMPONENT32F, mapSize.width, rows, strata);
        rasterizer.draw(frame.mesh, frame.plan.light, {&frame.plan.light.dynamicTriangles},
                        StochasticRasterizer::Role::Light, StochasticRasterizer::Output::DepthOnly,
                        {strata, 1.0f / strata}, nullptr, depth, nullptr, firstRow);
        std::vector<float> texels(static_cast<std::size_t>(mapSize.width * rows * strata));
        glGetTextureImage(depth.name(), 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                          static_cast<GLsizei>(texels.size() * sizeof(float)), texels.data());
        return texels;
    }
};

TEST(StochasticRows, PartsHoldWhatTheWholeDoes) {
    // Small triangles, which are drawn as points, and large ones, as rectangles.
    for (const bool aroundTheEye : {false, true}) {
        const auto scene = makeMovingScene({.quads = 60, .seed = 5, .aroundTheEye = aroundTheEye});
        RowsTechnique technique;
        sharedRenderer().draw(FramePlanner(*scene).plan(ProceduralScene::request(16, 12, 2, mapSize, 1)), technique,
                              View::Visibility);
        EXPECT_EQ(technique.different, 0u);
        const auto covered =
            std::count_if(technique.whole.begin(), technique.whole.end(), [](float d) { return d > 0; });
        EXPECT_GT(covered, 200) << "nothing is seen, so the test shows nothing";
    }
}

}  // namespace
}  // namespace timeshade
