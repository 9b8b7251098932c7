#pragma once

#include "options/measure_options.h"

namespace timeshade {

/// `timeshade measure --effects`: what each thing that moves in a scene costs, and what the plan saves. Returns the
/// exit code.
int runEffects(const MeasureOptions& options);

}  // namespace timeshade
