#pragma once

#include <memory>
#include <vector>

#include "measure/sweep.h"
#include "options/measure_options.h"

namespace timeshade {

/// What a command line measures: scenes, which `scenes` owns, techniques, by default all, with Embree's baseline or
/// without, samples, maps, rounds and sequence; progress on a terminal. Throws UsageError for an unknown technique, or
/// for the baseline where it is not wanted.
SweepOptions sweepOf(const MeasureOptions& options, bool withBaseline, std::vector<std::unique_ptr<Scene>>& scenes);

}  // namespace timeshade
