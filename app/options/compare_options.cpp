#include "options/compare_options.h"

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "compare/compared_side.h"
#include "core/error.h"
#include "options/option_checks.h"

namespace timeshade {

void declareOptions(CLI::App& app, CompareOptions& options) {
    app.option_defaults()->group("Comparison");
    app.add_option("--compare", options.compared,
                   "A,B in one picture: a technique, with settings after colons as in tsm:bias=2, its own samples too "
                   "as in exact:spp=2; and another, or truth (ray traced), or a file F.png or F.exr")
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
    app.add_option("--compare-gain", options.compareGain, "how many times as bright a difference is drawn")
        ->check(numberFrom(1, CompareOptions::mostGain))
        ->capture_default_str()
        ->multi_option_policy(lastWins);
}

void checkCompared(const CompareOptions& options, const SettingTexts& settings, bool drawn, const std::string& output) {
    if (options.compared.empty()) return;
    gl::ProgramCache programs;
    for (const std::string& text : options.compared) {
        const ComparedSide side = ComparedSide::of(text);
        if (side.kind == ComparedSide::Kind::Technique) {
            side.variant.make(settings, programs);
            if (&text == &options.compared.front() && side.samplesPerPixel)
                throw UsageError(fmt::format("--compare {}: the first has the picture's samples; expected --spp {}",
                                             text, *side.samplesPerPixel));
        } else if (&text == &options.compared.front()) {
            throw UsageError(fmt::format("--compare {},{}: expected a technique first, as in tsm,{}", text,
                                         options.compared.back(), text));
        }
    }
    if (!drawn) throw UsageError("--compare: is for pictures; expected view, shot or record");
    if (output.ends_with(".exr"))
        throw UsageError(fmt::format("-o {}: a comparison has labels; expected a name that ends in .png", output));
}

void requireTechniques(const CompareOptions& options, const std::string& why) {
    for (const std::string& text : options.compared)
        if (ComparedSide::of(text).kind != ComparedSide::Kind::Technique)
            throw UsageError(fmt::format("--compare {}: {}; expected two techniques", text, why));
}

}  // namespace timeshade
