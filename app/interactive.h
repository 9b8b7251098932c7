#pragma once

#include "options.h"

namespace timeshade {

/// `timeshade view`: the window. Returns the exit code.
int runInteractive(const Options& options);

}  // namespace timeshade
