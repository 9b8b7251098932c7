#include "options/compare_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "core/error.h"
#include "measure/technique_variant.h"
#include "options/option_checks.h"

namespace timeshade {

void declareOptions(CLI::App& app, CompareOptions& options) {
    app.option_defaults()->group("Comparison");
    app.add_option("--compare", options.compared,
                   "A,B: two techniques in one picture, with settings after colons as in tsm:bias=2,ranges")
        ->delimiter(',')
        ->expected(2)
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    addChoice<CompareMode>(
        app, "--compare-mode", options.compareMode,
        {{"wipe", CompareMode::Wipe}, {"side", CompareMode::Side}, {"difference", CompareMode::Difference}},
        "wipe, side, difference");
    app.add_option("--seam", options.seam, "where a wipe's seam lies: the share of the width that is the first's")
        ->check(numberFrom(0.0, 1.0))
        ->capture_default_str()
        ->multi_option_policy(lastWins);
}

void checkCompared(const CompareOptions& options, const SettingTexts& settings, bool drawn, const std::string& output) {
    if (options.compared.empty()) return;
    gl::ProgramCache programs;
    for (const std::string& variant : options.compared) TechniqueVariant::of(variant).make(settings, programs);
    if (!drawn) throw UsageError("--compare: is for pictures; expected view, shot or record");
    if (output.ends_with(".exr"))
        throw UsageError(fmt::format("-o {}: a comparison has labels; expected a name that ends in .png", output));
}

}  // namespace timeshade
