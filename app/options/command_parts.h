#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "options/command.h"
#include "options/option_checks.h"
#include "techniques/registry.h"

namespace timeshade {

/// What one command needs while its options are being read.
template <typename Options>
struct CommandReading {
    Options options;
    std::string view = "final";  ///< as typed
};

/// Declares what all commands that draw frames have in common. `reading` must live until all is parsed.
template <typename Options>
void declareDrawing(CLI::App& app, CommandReading<Options>& reading) {
    declareOptions(app, static_cast<FrameOptions&>(reading.options));
    declareOptions(app, static_cast<TechniqueOptions&>(reading.options), reading.view);
    declareOptions(app, static_cast<CompareOptions&>(reading.options));
    declareOptions(app, static_cast<RunOptions&>(reading.options));
    // Taken out beforehand; declared here for --help.
    app.add_option("--settings", "JSON file of these options; the command line wins");
}

/// Which kinds of pictures a command draws.
struct Draws {
    bool comparisons = false, diagnostics = false, techniqueViews = false;
};

/// Checks what no single option can: technique, settings, comparison and view together. Throws UsageError.
template <typename Options>
void checkDrawing(CommandReading<Options>& reading, const Draws& draws, const std::string& output) {
    Options& options = reading.options;
    gl::ProgramCache programs;
    makeTechnique(options.technique, programs);
    checkSettings(options.settings);
    checkCompared(options, options.settings, draws.comparisons, output);
    chooseView(reading.view, options, draws.diagnostics, draws.techniqueViews);
}

/// Once a command's options are read, `finish` completes and checks them; then they are what `command` holds.
template <typename Options, typename Finish>
void whenRead(CLI::App& app, Command& command, std::shared_ptr<CommandReading<Options>> reading, Finish finish) {
    app.final_callback([&command, reading = std::move(reading), finish = std::move(finish)] {
        finish(*reading);
        command = std::move(reading->options);
    });
}

}  // namespace timeshade
