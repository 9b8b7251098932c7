// Intervals of a texel, as C++ and as GLSL: what one hides of another, and what merging two costs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <random>
#include <vector>

#include "parity/compute.h"
#include "shared/map_interval.shared.h"

namespace timeshade {
namespace {

constexpr std::size_t inputs = 8, outputs = 7;

TEST(SharedMapInterval, IsTheSameInBothLanguages) {
    constexpr std::size_t count = 20000;
    std::mt19937 random(2011);
    const auto number = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    std::vector<float> input;
    for (std::size_t item = 0; item < count; ++item) {
        std::vector<float> begins{number(0.0f, 0.9f), number(0.0f, 0.9f)};
        std::sort(begins.begin(), begins.end());  // as neighbours are
        for (const float begin : begins)
            input.insert(input.end(), {begin, number(begin, 1.0f), number(1.0f, 20.0f), number(1.0f, 20.0f)});
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/map_interval.shared.h", R"(
    MapInterval a = MapInterval(in_(0), in_(1), in_(2), in_(3), 1u);
    MapInterval b = MapInterval(in_(4), in_(5), in_(6), in_(7), 2u);
    vec2 hidden = hiddenSpan(a, b), other = hiddenSpan(b, a);
    put(0, hidden.x);
    put(1, hidden.y);
    put(2, other.x);
    put(3, other.y);
    put(4, mergingError(a, b));
    put(5, depthAt(mergedOf(a, b), 0.5 * (a.begin + b.end)));
    put(6, clippedTo(a, 0.25 * a.begin + 0.75 * a.end, a.end).depthBegin);
)",
                                                       input, inputs, outputs);
    std::size_t hiding = 0;
    for (std::size_t item = 0; item < count; ++item) {
        const float* x = input.data() + inputs * item;
        const shared::MapInterval a{x[0], x[1], x[2], x[3], 1}, b{x[4], x[5], x[6], x[7], 2};
        const glm::vec2 hidden = shared::hiddenSpan(a, b), other = shared::hiddenSpan(b, a);
        const float expected[outputs] = {hidden.x,
                                         hidden.y,
                                         other.x,
                                         other.y,
                                         shared::mergingError(a, b),
                                         shared::depthAt(shared::mergedOf(a, b), 0.5f * (a.begin + b.end)),
                                         shared::clippedTo(a, 0.25f * a.begin + 0.75f * a.end, a.end).depthBegin};
        hiding += hidden.x < hidden.y || other.x < other.y ? 1u : 0u;
        // Of lines that nearly coincide, the place of their crossing is rounded by more.
        const float together = std::min(std::abs(x[2] - x[6]) + std::abs(x[3] - x[7]), 1.0f);
        for (std::size_t i = 0; i < outputs; ++i) {
            float value = 0.0f;
            std::memcpy(&value, output.data() + outputs * item + i, sizeof value);
            ASSERT_NEAR(value, expected[i], (i < 4 ? 1e-4f / std::max(together, 1e-2f) : 1e-4f)) << item << ", " << i;
        }
    }
    EXPECT_GT(hiding, count / 4);
}

}  // namespace
}  // namespace timeshade
