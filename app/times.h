#pragma once

#include "options/measure_options.h"

namespace timeshade {

/// `timeshade measure --times`: what frames take, on the device and on the processor, without any errors. Returns the
/// exit code.
int runTimes(const MeasureOptions& options);

}  // namespace timeshade
