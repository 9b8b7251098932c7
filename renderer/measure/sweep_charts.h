#pragma once

#include <string>
#include <vector>

#include "chart/chart.h"
#include "measure/sweep.h"

namespace timeshade {

/// The charts, for the window and for tests: image error or wrong samples of one scene against milliseconds of the
/// whole frame, of steady frames where a point has those.
enum class ChartOf { Error, Disagreement };
Chart sweepChart(const std::vector<SweepRow>& rows, const std::string& scene, ChartOf what, bool softwareRenderer);

/// The charts of a scene of which a setting was varied: one curve per technique, map and samples per pixel, against the
/// setting.
enum class VariedChartOf { Time, Memory, Disagreement };
Chart variedChart(const std::vector<SweepRow>& rows, const std::string& scene, VariedChartOf what,
                  bool softwareRenderer);

}  // namespace timeshade
