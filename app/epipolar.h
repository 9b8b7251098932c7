#pragma once

#include "options/epipolar_options.h"

namespace timeshade {

/// `timeshade epipolar`. Returns the exit code; throws Error where the pixel sees nothing.
int runEpipolar(const EpipolarOptions& options);

}  // namespace timeshade
