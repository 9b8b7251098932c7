#pragma once

#include <vector>

#include <glm/glm.hpp>

#include "plan/frame_plan.h"

namespace timeshade {

/// Corners of what the camera can see of the scene's bounds inside the light's map: the convex body that a focused map
/// has to cover (Brabec et al. 2002; body B of Wimmer, Scherzer, Purgathofer 2004). World space less the plan's origin.
/// Empty where the three have nothing in common. Camera and light must stand still within the shutter.
std::vector<glm::dvec3> seenBody(const FramePlan& plan, const ViewEnd& camera);

/// Corners of a convex body that holds whatever of the scene's bounds the camera sees at any time of the shutter;
/// inside the light's map, unless the light moves. The camera's eye and the corners of its image move along straight
/// lines, so that the hull of both ends' pyramids holds what lies between.
std::vector<glm::dvec3> sweptSeenBody(const FramePlan& plan);

/// How far along the view's middle, at least, the nearest triangle lies that the camera sees when the shutter opens or
/// closes. Infinite where it sees none.
double nearestSeen(const FramePlan& plan);

/// A world point on the light's map plane when the shutter opens, (s, t) in [0, 1] inside the map. It must lie in front
/// of the light.
glm::dvec2 onMapPlane(const ViewPlan& light, const glm::dvec3& point);

/// Corners of a convex polygon of the map plane that holds the body's points as the light sees them at any time of the
/// shutter, inside the map. Nothing where part of the body lies behind a light that moves, or too near in front of it.
/// A point seen by a light that moves goes along a straight line of the plane.
std::vector<glm::dvec2> sweptOnMapPlane(const ViewPlan& light, const std::vector<glm::dvec3>& body);

}  // namespace timeshade
