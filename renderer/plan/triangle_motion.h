#pragma once

#include <cstdint>
#include <vector>

#include <glm/glm.hpp>

#include "plan/view_plan.h"
#include "shared/swept_bounds.shared.h"

namespace timeshade {

/// Which side of a triangle a view is on during the shutter. A side is only named where it is the same throughout, by
/// more than floats may be wrong.
enum class Facing : std::uint8_t { Towards, Away, Unsure };

/// Where a triangle is in a view's picture during the shutter.
enum class Reach : std::uint8_t { Outside, Inside, Crossing };

/// What a triangle does in one view during the shutter, decided on the numbers that the GPU sees. Every answer is on
/// the safe side: what is called outside never comes in, what is called still has the same six view coordinates at both
/// ends, to the last bit.
struct ViewMotion {
    bool moves = true;  ///< relative to the view
    Facing facing = Facing::Unsure;
    Reach reach = Reach::Crossing;
    bool small = false;             ///< fits a point of at most maximumPointSide pixels in every stratum
    bool reachesNearPlane = false;  ///< perspective: a vertex is at the near plane or behind it at one end
};

/// What a triangle does during the shutter.
struct TriangleMotion {
    bool movesInWorld = false;
    bool nonTranslating = false;  ///< seen from the light its vertices take different ways: it turns or deforms
    bool doubleSided = false;
    bool shadowMayBeSeen = true;  ///< false: nothing that the camera sees can lie behind it, seen from the light
    ViewMotion camera, light;
};

/// How a view's lists are made.
struct ListRules {
    bool dropFacingAway = false;     ///< the camera sees no backs of one-sided triangles
    bool dropUnseenShadows = false;  ///< of moving casters: those whose shadow nobody sees
    bool allMove = false;            ///< what stands still is drawn as if it moved
};

/// The two views of a frame, and how the light moves: what a triangle's motion is relative to.
struct FrameViews {
    const ViewPlan& camera;
    const ViewPlan& light;
    const shared::FrameBlock& block;
};

/// The motion of triangle `id` of a mesh's uploaded texels (MeshTexels::positions). `inMap`: where in the light's map
/// it may be during the shutter, as boundsOf says.
TriangleMotion motionOf(const std::vector<glm::vec4>& positionTexels, std::uint32_t id, const FrameViews& views,
                        shared::SweptBounds& inMap);

/// Fills a view's lists in ascending order.
void listTriangles(ViewPlan& view, const std::vector<TriangleMotion>& triangles, ViewMotion TriangleMotion::*motion,
                   const ListRules& rules);

}  // namespace timeshade
