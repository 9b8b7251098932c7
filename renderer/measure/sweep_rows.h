#pragma once

#include <string>
#include <vector>

#include "measure/sweep.h"

namespace timeshade {

/// The steps that every frame has, as rows name them, in drawing order; "total" is their sum.
extern const std::vector<std::string> frameSteps;

/// The step's times; zeros where the row has none of that name.
Timing stepOf(const SweepRow& row, const std::string& name);

/// Names of the parts of steps ("build/collect") in any of the rows; of one scene, or of all where it is empty.
std::vector<std::string> partsOf(const std::vector<SweepRow>& rows, const std::string& scene);

/// Names of the scenes, each once, in the rows' order.
std::vector<std::string> scenesOf(const std::vector<SweepRow>& rows);

/// A row of the scene in which a setting of the scene was varied; null where none was.
const SweepRow* variedRow(const std::vector<SweepRow>& rows, const std::string& scene);

/// One row for each point: its steady one, or its cold one where nothing may be cached. What charts show.
std::vector<SweepRow> rowsOfCharts(const std::vector<SweepRow>& rows);

/// "tsm", or "tsm, map 256" where a technique was measured with several maps.
std::string curveName(const std::vector<SweepRow>& rows, const SweepPoint& point);

/// RMS of the shadow error; NaN where it was not measured.
double shadowErrorOf(const SweepRow& row);
/// Wrong shadow samples in a million; NaN where the technique's values are no single tests.
double wrongPpmOf(const SweepRow& row);
/// Whether any row has a shadow error.
bool haveShadowErrors(const std::vector<SweepRow>& rows);

/// Samples per pixel, "8", or the renders of brute force, "64x".
std::string sampleCountLabel(const SweepRow& row);

}  // namespace timeshade
