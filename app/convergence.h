#pragma once

#include "options.h"

namespace timeshade {

/// `timeshade measure --history-frames`: how a still picture converges with the number of frames. Returns the exit
/// code.
int runConvergence(const Options& options);

}  // namespace timeshade
