#pragma once

#include "options/reproduce_options.h"

namespace timeshade {

/// `timeshade reproduce`: runs the steps of a paper's figures, each as a process of its own, and writes report.md and
/// index.html. Returns 1 where a step or a chart has failed or a signal stopped it.
int runReproduce(const ReproduceOptions& options);

}  // namespace timeshade
