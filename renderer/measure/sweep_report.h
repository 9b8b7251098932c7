#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "measure/sweep.h"

namespace timeshade {

/// What stands beside every number: enough to measure it again.
struct SweepManifest {
    std::string commandLine;
    std::string commit;  ///< of the program; "unknown" outside a checkout
    std::string processor;
    std::string backEnd;
    gl::DeviceInfo device;
    std::vector<std::string> settings;  ///< "tsm.bias = 0.5", every setting of every technique measured
    std::map<std::string, std::vector<std::string>> plans;  ///< scene to its plan in words, a line each
};

/// Writes accuracy.csv, accuracy.json, manifest.json, report.md and pictures per scene into an existing folder:
/// SCENE-error.png (shadow error), SCENE-image-error.png and SCENE-disagreement.png, or, where a setting of the scene
/// was varied, SCENE-time.png, SCENE-memory.png and SCENE-disagreement.png against that. accuracy.png is the first
/// scene's first chart. Each file is whole or not there.
void writeSweepReport(const std::filesystem::path& folder, const SweepManifest& manifest,
                      const std::vector<SweepRow>& rows);

/// The table that accuracy.csv holds, one line per row and a header.
std::string sweepCsv(const std::vector<SweepRow>& rows);

}  // namespace timeshade
