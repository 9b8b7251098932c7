#pragma once

#include "options/verify_options.h"

namespace timeshade {

/// `timeshade verify`: agreement of a technique with the oracle. Returns 0, or 3 where --max-ppm is exceeded.
int runVerify(const VerifyOptions& options);

}  // namespace timeshade
