#pragma once

#include <vector>

#include "plan/frame_request.h"

namespace timeshade {

/// What the camera sees and when, as numbers that are equal exactly where that is the same. Neither size nor quality.
std::vector<double> momentKeyOf(const FrameRequest& request);

}  // namespace timeshade
