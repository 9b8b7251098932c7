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
    mask.cells.assign(std::size_t{side} * side, 0);
    const auto cellOf = [&](float position) {
        return static_cast<int>(std::floor(std::clamp(position, 0.0f, 1.0f) * static_cast<float>(side)));
    };
    for (const auto* list : {&casters.dynamicCasters, &casters.nearPlane}) {
        for (const std::uint32_t id : *list) {
            const shared::SweptBounds& bounds = inMap[id];
            const int left = cellOf(bounds.low.x - margin), right = std::min(cellOf(bounds.high.x + margin), side - 1);
            const int bottom = cellOf(bounds.low.y - margin), top = std::min(cellOf(bounds.high.y + margin), side - 1);
            for (int y = bottom; y <= top; ++y)
                for (int x = left; x <= right; ++x) mask.cells[static_cast<std::size_t>(y * side + x)] = 1;
        }
    }
    mask.marked = static_cast<std::size_t>(std::count(mask.cells.begin(), mask.cells.end(), std::uint8_t{1}));
    return mask;
}

}  // namespace timeshade
