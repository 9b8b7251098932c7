#pragma once

#include "plan/triangle_motion.h"
#include "plan/view_triangle.h"

namespace timeshade {

/// May the camera see anything that lies behind the triangle, seen from the light, at any time of the shutter?
/// `inCamera`: the triangle in the camera's view coordinates. False only where that is certain: the volume behind the
/// triangle lies outside one plane of the camera's frustum throughout, by far more than rounding. A turning camera is
/// not looked into: true.
bool shadowMayBeSeen(const FrameViews& views, const ViewTriangle& inCamera);

}  // namespace timeshade
