#pragma once

#include <cstdint>
#include <vector>

#include "plan/light_motion.h"

namespace timeshade {

/// Where in the shadow map a dynamic caster may be at any time of the shutter: a grid of bytes over the map, 0 where no
/// dynamic caster comes within four texels, which is the widest filter of a technique.
struct DynamicCasterMask {
    static constexpr int side = 128;
    std::vector<std::uint8_t> cells;  ///< [row, from t = 0 upwards][column], side * side; empty if not computed
    std::size_t marked = 0;           ///< cells that are not 0
};

/// Marks the cells of all dynamic casters. `inMap`: bounds of each triangle's path in the shadow map
/// (MotionClassifier::Motion). shortSide: texels along the map's shorter side.
DynamicCasterMask maskOfDynamicCasters(const LightMotion& casters, const std::vector<shared::SweptBounds>& inMap,
                                       int shortSide);

}  // namespace timeshade
