#include "plan/dynamic_caster_mask.h"

#include <algorithm>
#include <cmath>

namespace timeshade {

DynamicCasterMask maskOfDynamicCasters(const LightMotion& casters, const std::vector<shared::SweptBounds>& inMap,
                                       int shortSide) {
    constexpr int side = DynamicCasterMask::side;
    constexpr float widestFilter = 4.0f;  // texels
    const float margin = widestFilter / static_cast<float>(shortSide) + 1e-3f;
    DynamicCasterMask mask;
    // Rectangles as changes at their corners, summed up along rows and columns afterwards.
    constexpr int stride = side + 1;
    std::vector<std::int32_t> changes(std::size_t{stride} * stride, 0);
    const auto change = [&](int x, int y) -> std::int32_t& {
        return changes[static_cast<std::size_t>(y * stride + x)];
    };
    const auto cellOf = [&](float position) {
        return static_cast<int>(std::floor(std::clamp(position, 0.0f, 1.0f) * static_cast<float>(side)));
    };
    for (const auto* list : {&casters.dynamicCasters, &casters.nearPlane}) {
        for (const std::uint32_t id : *list) {
            const shared::SweptBounds& bounds = inMap[id];
            const int left = cellOf(bounds.low.x - margin), right = std::min(cellOf(bounds.high.x + margin), side - 1);
            const int bottom = cellOf(bounds.low.y - margin), top = std::min(cellOf(bounds.high.y + margin), side - 1);
            if (left > right || bottom > top) continue;
            ++change(left, bottom);
            --change(right + 1, bottom);
            --change(left, top + 1);
            ++change(right + 1, top + 1);
        }
    }
    mask.cells.assign(std::size_t{side} * side, 0);
    std::vector<std::int32_t> covers(side, 0);  // of the row below, by column
    for (int y = 0; y < side; ++y) {
        std::int32_t along = 0;
        for (int x = 0; x < side; ++x) {
            along += change(x, y);
            covers[static_cast<std::size_t>(x)] += along;
            if (covers[static_cast<std::size_t>(x)] == 0) continue;
            mask.cells[static_cast<std::size_t>(y * side + x)] = 1;
            ++mask.marked;
        }
    }
    return mask;
}

}  // namespace timeshade
