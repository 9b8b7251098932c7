#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "measure/sweep.h"
#include "measure/sweep_manifest.h"

namespace timeshade {

/// Writes accuracy.csv, accuracy.json, manifest.json, report.md and pictures per scene into an existing folder:
/// SCENE-error.png (shadow error), SCENE-image-error.png and SCENE-disagreement.png, or, where a setting of the scene
/// was varied, SCENE-time.png, SCENE-memory.png and SCENE-disagreement.png against that. accuracy.png is the first
/// scene's first chart. Each file is whole or not there.
void writeSweepReport(const std::filesystem::path& folder, const SweepManifest& manifest,
                      const std::vector<SweepRow>& rows);

/// The table that accuracy.csv holds, one line per row and a header.
std::string sweepCsv(const std::vector<SweepRow>& rows);

}  // namespace timeshade
