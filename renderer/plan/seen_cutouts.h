#pragma once

#include "plan/frame_plan.h"

namespace timeshade {

/// Throws Error that names the material, where the camera may see a triangle that is cut out by its alpha: interval
/// samples solve for when edges pass, and an outline of alpha has none.
void refuseSeenCutouts(const FramePlan& plan);

}  // namespace timeshade
