// The compression of visibility functions, as C++ and as GLSL, on the same functions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>
#include <vector>

#include "parity/compute.h"
#include "shared/visibility_function.shared.h"

namespace timeshade {
namespace {

constexpr std::size_t jumps = 12, inputs = 2 * jumps + 1, outputs = 4 * jumps + 1;

TEST(SharedVisibilityFunction, IsTheSameInBothLanguages) {
    constexpr std::size_t count = 4000;
    std::mt19937 random(1991);
    const auto number = [&](float low, float high) { return std::uniform_real_distribution(low, high)(random); };
    std::vector<float> input;
    for (std::size_t i = 0; i < count; ++i) {
        input.push_back(i % 7 == 0 ? 0.0f : number(0.0f, 0.1f));
        float depth = number(1.0f, 10.0f), visibility = 1.0f;
        for (std::size_t k = 0; k < jumps; ++k) {
            // Few depths and falls, exact in binary, so that both compute the same slopes or differ by roundings.
            depth += i % 3 == 0 ? number(0.001f, 1.0f) : 0.125f;
            visibility = std::max(visibility - (i % 2 == 0 ? 1.0f / 16.0f : number(0.0f, 0.2f)), 0.0f);
            input.push_back(depth);
            input.push_back(visibility);
        }
    }
    const std::vector<std::uint32_t> output = runOnGpu("shared/visibility_function.shared.h", R"(
    VisibilityWedge w = emptyVisibility(in_(24));
    for (int k = 0; k < 12; ++k) {
        int first = int(w.nodes);
        w = withJump(w, in_(2 * k + 1), in_(2 * k + 2), in_(0), k == 11);
        vec2 added[3] = vec2[](w.new0, w.new1, w.new2);
        for (int i = 0; i < int(w.newNodes); ++i) {
            put(1 + 2 * (first + i), added[i].x);
            put(2 + 2 * (first + i), added[i].y);
        }
    }
    put(0, w.nodes);
)",
                                                       input, inputs, outputs);
    std::size_t others = 0;
    for (std::size_t item = 0; item < count; ++item) {
        const float* x = input.data() + inputs * item;
        const std::uint32_t* found = output.data() + outputs * item;
        shared::VisibilityWedge w = shared::emptyVisibility(x[2 * jumps]);
        std::vector<float> expected;
        for (std::size_t k = 0; k < jumps; ++k) {
            w = shared::withJump(w, x[2 * k + 1], x[2 * k + 2], x[0], k + 1 == jumps);
            for (const glm::vec2& node : {w.new0, w.new1, w.new2})
                if (expected.size() < 2 * w.nodes) expected.insert(expected.end(), {node.x, node.y});
        }
        // A slope that is just possible may be just impossible after another rounding: another, as good function.
        if (found[0] != w.nodes) {
            ++others;
            continue;
        }
        for (std::size_t i = 0; i < expected.size(); ++i) {
            float value = 0.0f;
            std::memcpy(&value, found + 1 + i, sizeof value);
            ASSERT_NEAR(value, expected[i], 2e-6) << item;
        }
    }
    EXPECT_LE(others, count / 200);
}

}  // namespace
}  // namespace timeshade
