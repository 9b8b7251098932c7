#pragma once

#include "options.h"

namespace timeshade {

/// `timeshade measure`: accuracy against time, over scenes, techniques, samples per pixel and map sizes.
int runMeasure(const Options& options);

}  // namespace timeshade
