#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

namespace timeshade {

/// How --help looks: options in groups, what each takes, its default, and lines that fit a terminal.
class HelpFormatter final : public CLI::Formatter {
  public:
    HelpFormatter() { column_width(28); }
    std::string make_option(const CLI::Option* option, bool isPositional) const override;
    std::string make_group(std::string group, bool isPositional,
                           std::vector<const CLI::Option*> options) const override;
    std::string make_subcommand(const CLI::App* command) const override;
    std::string make_usage(const CLI::App* app, std::string name) const override;
};

/// What an option takes: "N", "X", "WORD", "TEXT"; empty for a switch.
std::string valueNameOf(const CLI::Option& option);
/// Its values where they are words: "auto", "on", "off".
std::vector<std::string> wordsOf(const CLI::Option& option);

/// What it does, its limits and its default.
std::string descriptionOf(const CLI::Option& option);

/// What --help and the manual show of how a command is used.
struct CommandExample {
    const char* command;
    const char* line;  ///< as typed
    const char* what;
};
const std::vector<CommandExample>& commandExamples();
/// Those of one command, as the end of its --help.
std::string examplesOf(const std::string& command);

}  // namespace timeshade
