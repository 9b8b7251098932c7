#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "plan/view_plan.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {

/// Which side of a triangle faces a view. Towards and Away hold during the whole shutter, by more than rounding.
enum class Facing : std::uint8_t { Towards, Away, Unsure };

/// Where a triangle is in a view's image during the shutter.
enum class Reach : std::uint8_t { Outside, Inside, Crossing };

/// The motion of a triangle relative to one view during the shutter, computed from the floats that the GPU uses.
/// Conservative: a triangle that is Outside never comes inside, and one that does not move has bitwise equal view
/// coordinates at both ends.
struct ViewMotion {
    bool moves = true;  ///< relative to the view
    Facing facing = Facing::Unsure;
    Reach reach = Reach::Crossing;
    bool small = false;             ///< can be drawn as a point of at most maximumPointSide pixels in every stratum
    bool reachesNearPlane = false;  ///< perspective: a vertex is at or behind the near plane at one end
};

/// The motion of a triangle during the shutter.
struct TriangleMotion {
    bool movesInWorld = false;
    bool nonTranslating = false;  ///< in the light's view its vertices have different displacements
    bool doubleSided = false;
    bool shadowMayBeSeen = true;  ///< false: the camera sees no point in its shadow (shadowMayBeSeen())
    ViewMotion camera, light;
};

/// Which triangles a view's lists contain.
struct ListRules {
    bool dropFacingAway = false;     ///< drop one-sided triangles that face away
    bool dropUnseenShadows = false;  ///< drop dynamic casters whose shadow the camera cannot see
    bool allMove = false;            ///< list static triangles as dynamic
};

/// The two views that a triangle's motion is relative to, and the light's positions and directions.
struct FrameViews {
    const ViewPlan& camera;
    const ViewPlan& light;
    const shared::FrameBlock& block;
};

/// The motion of triangle `id` of MeshTexels::positions. `inMap` receives the bounds of its path in the shadow map, as
/// boundsOf() computes them.
TriangleMotion motionOf(const std::vector<glm::vec4>& positionTexels, std::uint32_t id, const FrameViews& views,
                        shared::SweptBounds& inMap);

/// Fills a view's lists in ascending order.
void listTriangles(ViewPlan& view, const std::vector<TriangleMotion>& triangles, ViewMotion TriangleMotion::*motion,
                   const ListRules& rules);

}  // namespace timeshade
