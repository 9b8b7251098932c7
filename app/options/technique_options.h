#pragma once

#include <string>

#include "passes/shade_pass.h"
#include "scene_catalogue.h"

namespace CLI {
class App;
}

namespace timeshade {

/// Pictures of what is wrong with a picture.
enum class Diagnostic { None, Error, Disagreement };

/// Which technique with which settings, and what is shown of it.
struct TechniqueOptions {
    std::string technique = "tsm";
    SettingTexts settings;  ///< of techniques and of computed scenes: "tsm.bias", "0.5"
    View view = View::Final;
    Diagnostic diagnostic = Diagnostic::None;  ///< instead of `view`
    std::string techniqueView;  ///< name of one of the technique's own views, shown instead of `view`; empty for none
};

/// Declares the options of a technique on a command. `viewName` is what --view says: which views there are is known
/// only with technique and settings (see chooseView).
void declareOptions(CLI::App& app, TechniqueOptions& options, std::string& viewName);

/// Declares --set alone.
void declareSettings(CLI::App& app, SettingTexts& settings, const std::string& help);

/// Settings are checked at once against what declares them, so that a typing error costs no rendering. Throws
/// UsageError.
void checkSettings(const SettingTexts& settings);

/// Turns the name that --view gives into one of the program's views, a diagnostic, or one of the technique's views.
/// Throws UsageError where there is no such view, or the command draws none of its kind.
void chooseView(const std::string& name, TechniqueOptions& options, bool diagnosticsDrawn, bool techniqueViewsDrawn);

}  // namespace timeshade
