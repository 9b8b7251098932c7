#pragma once

#include "plan/frame_plan.h"

namespace timeshade {

/// For a plan whose samples are no longer those that it was planned with: nothing that was kept for others stands in
/// for these, and nothing of these is kept.
inline void keepNoSamples(FramePlan& plan) {
    plan.versions.samples = plan.versions.lit = plan.versions.shading = 0;
    plan.reached = {};
}

}  // namespace timeshade
