#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/triangle_motion.h"

namespace timeshade {

/// The triangles that may cast a shadow in this shutter, each in one list, by how they move in the light's own frame
/// (its map travels with the light, so what moves along with a moving light stands still there). Ascending order.
/// Triangles that never come inside the map are in none, nor are moving ones whose shadow nobody sees.
struct LightMotion {
    std::vector<std::uint32_t>
        staticCasters;  ///< all six view coordinates are the same numbers at both ends: one depth says all
    std::vector<std::uint32_t>
        dynamicCasters;  ///< in front of the near plane throughout: the swept volume has a projection
    std::vector<std::uint32_t>
        nearPlane;  ///< moving, and a vertex is at the near plane or behind it at one end (spot only)
    std::size_t nonTranslating =
        0;  ///< of `dynamicCasters`: the vertices do not all move alike, so the swept sides are not flat
    bool nothingMoves() const { return dynamicCasters.empty() && nearPlane.empty(); }
};

/// The rules are those of the light's own lists.
LightMotion casterLists(const std::vector<TriangleMotion>& triangles, const ListRules& rules);

}  // namespace timeshade
