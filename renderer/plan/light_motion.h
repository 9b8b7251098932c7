#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "plan/triangle_motion.h"

namespace timeshade {

/// The triangles that may cast a visible shadow in this shutter, by their motion relative to the light: the shadow map
/// is translated with the light, so a caster that moves along with it is static here. Each is in one list, in ascending
/// order. Triangles that are never inside the map, and dynamic ones whose shadow the camera cannot see, are in none.
struct LightMotion {
    /// The positions in the light's view are bitwise equal at both ends: one depth map describes them.
    std::vector<std::uint32_t> staticCasters;
    /// Dynamic, and in front of the near plane during the whole shutter, so that the swept volume can be projected.
    std::vector<std::uint32_t> dynamicCasters;
    /// Dynamic, with a vertex at or behind the near plane at one end (spot lights only).
    std::vector<std::uint32_t> nearPlane;
    /// Of `dynamicCasters`: those whose vertices have different displacements, so that swept sides are not planar.
    std::size_t nonTranslating = 0;
    bool nothingMoves() const { return dynamicCasters.empty() && nearPlane.empty(); }
};

/// All three lists as one, in ascending order.
std::vector<std::uint32_t> allOf(const LightMotion& lists);

/// `rules`: as for the light's view (listTriangles).
LightMotion casterLists(const std::vector<TriangleMotion>& triangles, const ListRules& rules);

}  // namespace timeshade
