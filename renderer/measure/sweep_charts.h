#pragma once

#include <string>
#include <vector>

#include "chart/chart.h"
#include "measure/sweep.h"

namespace timeshade {

/// The charts of one scene, for the window and for tests: RMS shadow error, image RMSE or wrong samples against
/// milliseconds of the whole frame, of steady frames where a point has those. Points without the value are left out.
enum class ChartOf { ShadowError, ImageError, Disagreement };
Chart sweepChart(const std::vector<SweepRow>& rows, const std::string& scene, ChartOf what, bool softwareRenderer);

/// The charts of a scene of which a setting was varied: one curve per technique, map and samples per pixel, against the
/// setting.
enum class VariedChartOf { Time, Memory, Disagreement };
Chart variedChart(const std::vector<SweepRow>& rows, const std::string& scene, VariedChartOf what,
                  bool softwareRenderer);

}  // namespace timeshade
