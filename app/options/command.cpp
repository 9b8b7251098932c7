#include "options/command.h"

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <timeshade/commit.h>  // generated
#include <CLI/CLI.hpp>

#include "core/data_folder.h"
#include "core/error.h"
#include "core/nearest_word.h"
#include "options/help.h"
#include "options/help_files.h"
#include "scene_catalogue.h"
#include "settings_file.h"

namespace timeshade {

namespace {

/// Takes every `--settings F` out of the arguments. What the files say, in order.
std::vector<FileSetting> takeSettingsFiles(std::vector<std::string>& arguments) {
    std::vector<FileSetting> ofFiles;
    std::vector<std::string> others;
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        const bool joined = arguments[i].rfind("--settings=", 0) == 0;
        if (!joined && (arguments[i] != "--settings" || i + 1 >= arguments.size())) {
            others.push_back(arguments[i]);
            continue;
        }
        const std::vector<FileSetting> more = readSettingsFile(joined ? arguments[i].substr(11) : arguments[++i]);
        ofFiles.insert(ofFiles.end(), more.begin(), more.end());
    }
    arguments = std::move(others);
    return ofFiles;
}

/// The arguments with the first `count` settings right behind the command's name, so that the command line wins, and of
/// two files the later.
std::vector<std::string> withSettings(const std::vector<std::string>& arguments,
                                      const std::vector<FileSetting>& settings, std::size_t count) {
    std::vector<std::string> all;
    for (std::size_t i = 0; i < count; ++i)
        all.insert(all.end(), settings[i].arguments.begin(), settings[i].arguments.end());
    std::vector<std::string> whole = arguments;
    whole.insert(whole.begin() + 1, all.begin(), all.end());
    return whole;
}

const std::vector<std::string>& commandNames() {
    static const std::vector<std::string> names{"view",    "shot",     "record",    "pictures", "verify",
                                                "measure", "epipolar", "reproduce", "cases",    "list"};
    return names;
}

bool isCommand(const std::string& word) {
    return std::find(commandNames().begin(), commandNames().end(), word) != commandNames().end();
}

/// Neither a command nor anything that could be a scene, but nearly a command.
void refuseMisspelt(const std::string& word) {
    if (isCommand(word) || word.starts_with("-") || word.find_first_of("./:") != std::string::npos) return;
    for (const BuiltInScene& scene : builtInScenes())
        if (scene.name == word) return;
    std::vector<std::string> known = commandNames();
    known.push_back("help");
    if (const std::optional<std::string> meant = nearestWord(word, known))
        throw UsageError(fmt::format("'{}': no such command and no scene; did you mean {}? Expected one of {}", word,
                                     *meant, fmt::join(known, ", ")));
}

/// `timeshade help` and `timeshade help shot` are `timeshade --help` and `timeshade shot --help`.
void turnHelp(std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.front() != "help") return;
    if (arguments.size() == 1) {
        arguments = {"--help"};
        return;
    }
    if (arguments[1].starts_with("--")) return;  // the manual and completion
    if (!isCommand(arguments[1]))
        throw UsageError(fmt::format("help {}: no such command{}; expected one of {}", arguments[1],
                                     didYouMean(arguments[1], commandNames()), fmt::join(commandNames(), ", ")));
    arguments = {arguments[1], "--help"};
}

/// `timeshade` alone and `timeshade chess` mean the window; the first of them shows assets/story.json.
void addDefaultCommand(std::vector<std::string>& arguments) {
    turnHelp(arguments);
    const std::vector<std::string> others{"--help", "-h", "--version", "help"};
    if (!arguments.empty() && std::find(others.begin(), others.end(), arguments.front()) != others.end()) return;
    if (!arguments.empty()) refuseMisspelt(arguments.front());
    if (arguments.empty() || !isCommand(arguments.front())) arguments.insert(arguments.begin(), "view");
}

/// The first argument that looks like an option and is none of the command's: what may have been meant.
std::string suggestionFor(const CLI::App& app, const std::vector<std::string>& arguments) {
    const CLI::App* command =
        !arguments.empty() && isCommand(arguments.front()) ? app.get_subcommand(arguments.front()) : &app;
    std::vector<std::string> known;
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames()) known.push_back("--" + name);
    for (const std::string& argument : arguments) {
        const std::string name = argument.substr(0, argument.find('='));
        if (name.starts_with("--") && std::find(known.begin(), known.end(), name) == known.end())
            return didYouMean(name, known);
    }
    return "";
}

void keepCommandLine(Command& command, const std::string& typed) {
    const auto keep = [&](auto& options) {
        if constexpr (std::is_base_of_v<RunOptions, std::decay_t<decltype(options)>>) options.commandLine = typed;
    };
    std::visit(keep, command);
    if (auto* reproduce = std::get_if<ReproduceOptions>(&command)) reproduce->commandLine = typed;
}

}  // namespace

Command parseArguments(const std::vector<std::string>& given) {
    Command command;
    CLI::App app("A real-time laboratory for motion-blurred shadows", "timeshade");
    app.formatter(std::make_shared<HelpFormatter>());
    app.footer(
        "timeshade help COMMAND, or COMMAND --help, lists a command's options. Without a command the window "
        "opens.\n\n" +
        examplesOf("view"));
    app.set_version_flag("--version", "timeshade " TIMESHADE_VERSION " (commit " TIMESHADE_COMMIT ")");
    app.require_subcommand(1);
    app.option_defaults()->delimiter('\0');
    addViewCommand(app, command);
    addShotCommand(app, command);
    addRecordCommand(app, command);
    addPicturesCommand(app, command);
    addVerifyCommand(app, command);
    addMeasureCommand(app, command);
    addEpipolarCommand(app, command);
    addReproduceCommand(app, command);
    addCasesCommand(app, command);
    addListCommand(app, command);
    addHelpCommand(app);
    for (CLI::App* each : app.get_subcommands({})) each->group("Commands")->footer(examplesOf(each->get_name()));
    std::vector<std::string> arguments(given.rbegin(), given.rend());  // what CLI11 expects of a vector
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {
        std::exit(app.exit(success));
    } catch (const CLI::ParseError& error) {
        const bool known = !given.empty() && isCommand(given.front());
        throw UsageError(fmt::format("{}{} (timeshade help{})", error.what(), suggestionFor(app, given),
                                     known ? " " + given.front() : ""));
    }
    if (auto* record = std::get_if<RecordOptions>(&command)) record->arguments = given;
    return command;
}

Command parseWithSettings(const std::vector<std::string>& arguments, const std::vector<FileSetting>& settings) {
    try {
        return parseArguments(withSettings(arguments, settings, settings.size()));
    } catch (const UsageError& error) {
        // The first setting without which all was well is named with its place. By halves: a file may have thousands.
        const auto isWell = [&](std::size_t count) {
            try {
                parseArguments(withSettings(arguments, settings, count));
                return true;
            } catch (const UsageError&) {
                return false;
            }
        };
        if (settings.empty() || !isWell(0)) throw;
        std::size_t good = 0, bad = settings.size();
        while (bad - good > 1) (isWell((good + bad) / 2) ? good : bad) = (good + bad) / 2;
        throw UsageError(fmt::format("{}: {}", settings[good].place, error.what()));
    }
}

Command parseCommandLine(int argumentCount, char** argumentValues) {
    std::vector<std::string> arguments(argumentValues + 1, argumentValues + argumentCount);
    std::string typed = "timeshade";
    for (const std::string& argument : arguments) typed += " " + argument;
    addDefaultCommand(arguments);
    const bool story = arguments == std::vector<std::string>{"view"};
    const std::vector<FileSetting> ofFiles =
        story ? readSettingsFile((dataFolder() / "assets" / "story.json").string()) : takeSettingsFiles(arguments);
    Command command = parseWithSettings(arguments, ofFiles);
    if (story) std::get<ViewOptions>(command).story = true;
    keepCommandLine(command, typed);
    return command;
}

}  // namespace timeshade
