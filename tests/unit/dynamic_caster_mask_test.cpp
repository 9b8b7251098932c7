// The mask of dynamic casters against its definition: every cell of every rectangle, one by one.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "plan/dynamic_caster_mask.h"

namespace timeshade {
namespace {

std::vector<std::uint8_t> cellByCell(const std::vector<shared::SweptBounds>& bounds, int shortSide) {
    constexpr int side = DynamicCasterMask::side;
    const float margin = 4.0f / static_cast<float>(shortSide) + 1e-3f;
    std::vector<std::uint8_t> cells(std::size_t{side} * side, 0);
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x)
            for (const shared::SweptBounds& b : bounds) {
                const auto within = [&](int cell, float low, float high) {
                    // What lies beyond the map counts to its outermost cells.
                    const float from = std::clamp(low - margin, 0.0f, 1.0f) * side,
                                to = std::clamp(high + margin, 0.0f, 1.0f) * side;
                    const int first = static_cast<int>(from), last = std::min(static_cast<int>(to), side - 1);
                    return cell >= first && cell <= last;
                };
                if (within(x, b.low.x, b.high.x) && within(y, b.low.y, b.high.y))
                    cells[static_cast<std::size_t>(y * side + x)] = 1;
            }
    return cells;
}

TEST(DynamicCasterMask, MarksEveryCellOfEveryCaster) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-0.2f, 1.2f), size(0.0f, 0.2f);
    for (int round = 0; round < 40; ++round) {
        LightMotion casters;
        std::vector<shared::SweptBounds> bounds;
        for (std::uint32_t id = 0; id < static_cast<std::uint32_t>(round % 7); ++id) {
            const glm::vec2 low(place(random), place(random));
            bounds.push_back({low, low + glm::vec2(size(random), size(random)), 0});
            (id % 3 == 2 ? casters.nearPlane : casters.dynamicCasters).push_back(id);
        }
        const DynamicCasterMask mask = maskOfDynamicCasters(casters, bounds, 512);
        const std::vector<std::uint8_t> expected = cellByCell(bounds, 512);
        EXPECT_EQ(mask.cells, expected);
        EXPECT_EQ(mask.marked, static_cast<std::size_t>(std::count(expected.begin(), expected.end(), 1)));
    }
}

}  // namespace
}  // namespace timeshade
