#pragma once

#include <string>
#include <vector>

#include "compare/compare_mode.h"
#include "scene_catalogue.h"

namespace CLI {
class App;
}

namespace timeshade {

/// Two pictures of a moment in one.
struct CompareOptions {
    std::vector<std::string> compared;  ///< two of ComparedSide; empty for --technique alone
    CompareMode compareMode = CompareMode::Wipe;
    double seam = 0.5;    ///< share of a wipe's width that is the first's, in [0, 1]
    int compareGain = 4;  ///< how many times as bright a difference is drawn

    static constexpr int mostGain = 255;
};

/// Declares the options of a comparison on a command.
void declareOptions(CLI::App& app, CompareOptions& options);

/// Tries both variants with the settings. Throws UsageError where one is wrong, or a comparison is asked for of a
/// command that draws none (`drawn` false), or as an .exr (it has labels), or where the first is no technique.
void checkCompared(const CompareOptions& options, const SettingTexts& settings, bool drawn, const std::string& output);

/// Throws UsageError where --compare names the ground truth or a file; `why` says what needs two techniques.
void requireTechniques(const CompareOptions& options, const std::string& why);

}  // namespace timeshade
