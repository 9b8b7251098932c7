#pragma once

#include "options/measure_options.h"

namespace timeshade {

/// `timeshade measure`: accuracy against time, over scenes, techniques, samples per pixel and map sizes.
int runMeasure(const MeasureOptions& options);

}  // namespace timeshade
