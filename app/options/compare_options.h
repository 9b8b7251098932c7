#pragma once

#include <string>
#include <vector>

#include "compare/compare_mode.h"
#include "scene_catalogue.h"

namespace CLI {
class App;
}

namespace timeshade {

/// Two techniques in one picture.
struct CompareOptions {
    std::vector<std::string> compared;  ///< two TechniqueVariants; empty for --technique alone
    CompareMode compareMode = CompareMode::Wipe;
    double seam = 0.5;  ///< share of a wipe's width that is the first's, in [0, 1]
};

/// Declares the options of a comparison on a command.
void declareOptions(CLI::App& app, CompareOptions& options);

/// Tries both variants with the settings. Throws UsageError where one is wrong, or a comparison is asked for of a
/// command that draws none (`drawn` false), or as an .exr (it has labels).
void checkCompared(const CompareOptions& options, const SettingTexts& settings, bool drawn, const std::string& output);

}  // namespace timeshade
