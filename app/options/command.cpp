#include "options/command.h"

#include <algorithm>
#include <cstdlib>
#include <type_traits>
#include <utility>

#include <fmt/format.h>
#include <timeshade/commit.h>  // generated
#include <CLI/CLI.hpp>

#include "core/data_folder.h"
#include "core/error.h"
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

/// `timeshade` alone and `timeshade chess` mean the window; the first of them shows assets/story.json.
void addDefaultCommand(std::vector<std::string>& arguments) {
    const std::vector<std::string> commands{"view",    "shot",     "record", "pictures", "verify",
                                            "measure", "epipolar", "cases",  "list"};
    const bool asks = !arguments.empty() &&
                      (arguments.front() == "--help" || arguments.front() == "-h" || arguments.front() == "--version");
    if (asks) return;
    const bool known =
        !arguments.empty() && std::find(commands.begin(), commands.end(), arguments.front()) != commands.end();
    if (!known) arguments.insert(arguments.begin(), "view");
}

void keepCommandLine(Command& command, const std::string& typed) {
    const auto keep = [&](auto& options) {
        if constexpr (std::is_base_of_v<RunOptions, std::decay_t<decltype(options)>>) options.commandLine = typed;
    };
    std::visit(keep, command);
}

}  // namespace

Command parseArguments(const std::vector<std::string>& given) {
    Command command;
    CLI::App app("A real-time laboratory for motion-blurred shadows", "timeshade");
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
    addCasesCommand(app, command);
    addListCommand(app, command);
    std::vector<std::string> arguments(given.rbegin(), given.rend());  // what CLI11 expects of a vector
    try {
        app.parse(arguments);
    } catch (const CLI::Success& success) {
        std::exit(app.exit(success));
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (timeshade --help)");
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
