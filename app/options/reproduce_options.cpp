#include "options/reproduce_options.h"

#include <filesystem>

#include "core/error.h"
#include "options/command_parts.h"

namespace timeshade {

void addReproduceCommand(CLI::App& app, Command& command) {
    CLI::App* reproduce =
        app.add_subcommand("reproduce", "redraw a paper's figures, with its numbers beside ours and a verdict");
    auto reading = std::make_shared<CommandReading<ReproduceOptions>>();
    ReproduceOptions& options = reading->options;
    reproduce->add_option("paper", options.paper, "names of papers, as hong2017 or hong2017,hong2019, or all")
        ->required()
        ->check(notEmpty("a paper's name"));
    reproduce->add_option("figures", options.figures, "numbers of figures, as 4.1 (default: all)");
    reproduce->add_option("-o,--output", options.output, "folder; what was interrupted goes on there")
        ->required()
        ->check(notEmpty("a folder"));
    reproduce->add_flag("--quick", options.quick, "smaller pictures and fewer measurements, for a machine without GPU");
    reproduce
        ->add_option("--claims", options.claims,
                     "F.md: also a table of all claims and verdicts, with pictures of the refuted ones beside it, in "
                     "pictures/claims")
        ->check(notEmpty("a file name"))
        ->multi_option_policy(lastWins);
    whenRead(*reproduce, command, reading, [](CommandReading<ReproduceOptions>& read) {
        const std::string& claims = read.options.claims;
        if (!claims.empty() && std::filesystem::path(claims).extension() != ".md")
            throw UsageError(fmt::format("--claims {}: expected a name that ends in .md", claims));
    });
}

}  // namespace timeshade
