#pragma once

#include "options/measure_options.h"

namespace timeshade {

/// `timeshade measure --convergence`: how a still picture converges with the number of frames. Returns the exit
/// code.
int runConvergence(const MeasureOptions& options);

}  // namespace timeshade
