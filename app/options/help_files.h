#pragma once

#include <string>

namespace CLI {
class App;
}

namespace timeshade {

/// Declares `help`, which writes what is installed beside the program: its manual page and what shells complete with.
/// Each is made of the declarations of all commands, and printed at once; the program ends then.
void addHelpCommand(CLI::App& app);

/// The manual page timeshade.1, of all commands that are declared on the program.
std::string manualOf(const CLI::App& app);
/// A script for bash, and one for zsh or fish.
std::string completionOf(const CLI::App& app, const std::string& shell);

}  // namespace timeshade
