#include "options/cases_options.h"

#include "core/error.h"
#include "options/command_parts.h"

namespace timeshade {

void addCasesCommand(CLI::App& app, Command& command) {
    CLI::App* cases = app.add_subcommand("cases", "analytic cases: every technique's value beside the exact one");
    auto reading = std::make_shared<CommandReading<CasesOptions>>();
    CasesOptions& options = reading->options;
    cases->add_option("-o,--output", options.output, "F.png: the matrix as a picture");
    cases->add_option("--technique,--techniques", options.measuredTechniques, "names, as in static,tsm (default: all)")
        ->delimiter(',');
    declareSamples(*cases, options.samplesPerPixel);
    declareMapSize(*cases, options.mapSize, "shadow map size: texels along a side, or WIDTHxHEIGHT (default: 512)");
    declareContext(*cases, options);
    declareSettings(*cases, options.settings, "TECHNIQUE.KEY=VALUE, repeatable (list shows the keys)");
    cases->add_option("--json", options.json, "write the matrix as JSON; - prints it")
        ->check(notEmpty("a file name"))
        ->multi_option_policy(lastWins);
    whenRead(*cases, command, reading, [](CommandReading<CasesOptions>& read) {
        const std::string& path = read.options.output;
        if (!path.empty() && !path.ends_with(".png"))
            throw UsageError(fmt::format("-o {}: expected a name that ends in .png", path));
        checkSettings(read.options.settings);
    });
}

}  // namespace timeshade
