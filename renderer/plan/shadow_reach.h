#pragma once

#include "plan/triangle_motion.h"
#include "plan/view_triangle.h"

namespace timeshade {

/// Whether the camera may see a point behind the triangle, seen from the light, at any time of the shutter. `inCamera`:
/// the triangle in the camera's view coordinates. Conservative: false only if the shadow volume is outside one plane of
/// the camera's frustum during the whole shutter, by much more than rounding. Always true for a camera that turns.
bool shadowMayBeSeen(const FrameViews& views, const ViewTriangle& inCamera);

}  // namespace timeshade
