#pragma once

#include "options/measure_options.h"

namespace timeshade {

/// `timeshade measure --equal-time` and `--equal-error`: with how many samples techniques take as long, or err as
/// little, as the first one, and how they look then. Returns the exit code.
int runEqual(const MeasureOptions& options);

}  // namespace timeshade
