#pragma once

#include <cstdint>
#include <vector>

#include "plan/light_motion.h"

namespace timeshade {

/// Where in the light's map a moving caster may be at any time of the shutter: a grid of bytes over the map, 0 where
/// none comes within four texels (the widest that a technique's test looks aside).
struct DynamicCasterMask {
    static constexpr int side = 128;
    std::vector<std::uint8_t> cells;  ///< [row from t = 0][column], side * side; empty: not made
    std::size_t marked = 0;
};

/// Of the lists of what moves; `inMap`: where in the light's map each triangle may be (MotionClassifier).
DynamicCasterMask maskOfDynamicCasters(const LightMotion& casters, const std::vector<shared::SweptBounds>& inMap,
                                       int mapSize);

}  // namespace timeshade
