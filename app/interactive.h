#pragma once

#include "options/view_options.h"

namespace timeshade {

/// `timeshade view`: the window. Returns the exit code.
int runInteractive(const ViewOptions& options);

}  // namespace timeshade
