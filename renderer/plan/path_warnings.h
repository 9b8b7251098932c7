#pragma once

#include <optional>
#include <vector>

#include "plan/frame_plan.h"
#include "plan/planned_light.h"

namespace timeshade {

/// What the motion of a frame leaves out, in one line each: things, the camera and the light that leave their straight
/// path inside the shutter by more than half a pixel or half a texel of the shadow map, and jumps that were moved to an
/// end of it. `inner`: of the scene at `times`, whose plan has mesh, views and light already; `light`: the same light.
std::vector<PathWarning> pathWarnings(const Scene& scene, const FramePlan& plan, const InnerMotion& inner,
                                      const ShutterTimes& times, const PlannedLight& light);

/// Shadow maps and what is built on them take a caster's path in the map as straight. Where a sun turns over one that
/// moves it is a parabola: what they may be off by.
std::optional<PathWarning> bentPathWarning(const FramePlan& plan);

}  // namespace timeshade
