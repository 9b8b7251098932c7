#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/equal_measurement.h"
#include "measure/sweep_manifest.h"

namespace timeshade {

/// Whether the technique came level with the first, in one line: "equal: 35.9 ms against 35.2 ms (2.0 % more)"; "could
/// not: 4 spp 31.2 ms, 5 spp 39.0 ms against 35.0 ms". Empty for the first.
std::string verdictOf(const EqualRow& row, EqualLevel level, const EqualRow& first);

/// The techniques' pictures and the reference side by side, each with its samples, time and error; below each a
/// detail, where the one with the largest shadow error is most wrong. `software`: milliseconds are said to be those of
/// a software renderer.
DisplayImage equalPicture(const EqualScene& scene, bool software);

/// The table that equal.csv holds, one line for each technique in each scene, and a header.
std::string equalCsv(const std::vector<EqualScene>& scenes, EqualLevel level);

/// Writes equal.csv, equal.json, report.md and a picture per scene, SCENE-equal.png, into an existing folder. Each file
/// is whole or not there.
void writeEqualReport(const std::filesystem::path& folder, const SweepManifest& manifest, EqualLevel level,
                      const std::vector<EqualScene>& scenes);

}  // namespace timeshade
