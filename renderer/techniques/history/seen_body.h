#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// Corners of what the camera can see of the scene's bounds inside the light's map, at the given end of the shutter:
/// the convex body that a focused map has to cover (Brabec et al. 2002; body B of Wimmer et al. 2004). World space less
/// the plan's origin. Empty where the three have nothing in common.
std::vector<glm::dvec3> seenBody(const FramePlan& plan, const ViewEnd& camera);

/// A world point on the light's map plane, (s, t) in [0, 1] inside the map. It must lie in front of the light.
glm::dvec2 onMapPlane(const ViewPlan& light, const glm::dvec3& point);

}  // namespace timeshade
