#include "options/help_files.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "options/help.h"
#include "options/option_checks.h"
#include "scene_catalogue.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

std::vector<const CLI::App*> commandsOf(const CLI::App& app) {
    std::vector<const CLI::App*> commands;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        if (command->get_name() != "help") commands.push_back(command);
    return commands;
}

/// Those that --help shows.
std::vector<const CLI::Option*> optionsOf(const CLI::App& command) {
    std::vector<const CLI::Option*> options;
    for (const CLI::Option* option : command.get_options())
        if (!option->get_group().empty() && option->nonpositional()) options.push_back(option);
    return options;
}

std::vector<std::string> namesOf(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

std::vector<std::string> sceneNames() {
    std::vector<std::string> names;
    for (const BuiltInScene& scene : builtInScenes()) names.push_back(scene.name);
    return names;
}

/// What may follow an option, where that can be listed.
std::vector<std::string> valuesOf(const CLI::Option& option) {
    if (option.check_lname("scene")) return sceneNames();
    if (option.check_lname("technique") || option.check_lname("techniques")) {
        std::vector<std::string> names;
        for (const TechniqueDescription& technique : techniqueDescriptions()) names.push_back(technique.name);
        return names;
    }
    return wordsOf(option);
}

/// Characters that troff would take for its own.
std::string forManual(const std::string& text) {
    std::string safe;
    for (const char c : text) {
        if (c == '\\')
            safe += "\\e";
        else if (c == '-')
            safe += "\\-";
        else if ((c == '.' || c == '\'') && (safe.empty() || safe.back() == '\n'))
            safe += std::string("\\&") + c;
        else
            safe += c;
    }
    return safe;
}

std::string manualOfOption(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : namesOf(option)) names.push_back("\\fB" + forManual(name) + "\\fR");
    const std::string takes = valueNameOf(option);
    return fmt::format(".TP\n{}{}\n{}\n", fmt::join(names, ", "), takes.empty() ? "" : " \\fI" + takes + "\\fR",
                       forManual(descriptionOf(option)));
}

constexpr const char* manualHead = R"(.TH TIMESHADE 1 "" "Timeshade" "User commands"
.SH NAME
timeshade \- a real\-time laboratory for motion\-blurred shadows
.SH SYNOPSIS
.B timeshade
.RI [ command ]
.RI [ scene ]
.RI [ options ]
.SH DESCRIPTION
Draws moving scenes with every published real\-time technique for motion\-blurred shadows, on the same camera samples,
and says how wrong each is and what that costs.
.PP
A scene is the name of a built\-in one or a file in glTF 2.0 (.gltf, .glb). Without a command the window opens.
)";

constexpr const char* manualEnd = R"(.SH EXIT STATUS
0: done. 1: it failed, and nothing is half written. 2: the command line is wrong. 3: more samples disagree than
\fBverify \-\-max\-ppm\fR allows.
.SH ENVIRONMENT
.TP
.B TIMESHADE_DATA
the folder of shaders and scenes, instead of ../share/timeshade beside the program.
.TP
.BR TIMESHADE_SHADERS ", " TIMESHADE_SCENES
these alone.
.SH FILES
.I ~/.config/timeshade/window.json
holds the size of the window and recent files.
)";

/// Of bash: in double quotes.
std::string wordList(const std::vector<std::string>& words) { return fmt::format("\"{}\"", fmt::join(words, " ")); }

std::vector<std::string> allNames(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : optionsOf(command))
        for (const std::string& name : namesOf(*option)) names.push_back(name);
    return names;
}

std::vector<std::string> commandNamesOf(const CLI::App& app) {
    std::vector<std::string> names{"help", "--help", "--version"};
    for (const CLI::App* command : commandsOf(app)) names.push_back(command->get_name());
    return names;
}

/// Values by option, of all commands: an option means the same in each.
std::vector<std::pair<std::string, std::vector<std::string>>> listedValues(const CLI::App& app) {
    std::vector<std::pair<std::string, std::vector<std::string>>> listed;
    for (const CLI::App* command : commandsOf(app))
        for (const CLI::Option* option : optionsOf(*command)) {
            const std::vector<std::string> values = valuesOf(*option);
            if (values.empty()) continue;
            const std::string names = fmt::format("{}", fmt::join(namesOf(*option), "|"));
            const bool known =
                std::any_of(listed.begin(), listed.end(), [&](const auto& each) { return each.first == names; });
            if (!known) listed.emplace_back(names, values);
        }
    return listed;
}

std::string bashOf(const CLI::App& app) {
    std::string text =
        "# Completion of bash for timeshade; made by `timeshade help --completion bash`.\n"
        "_timeshade() {\n"
        "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} command=${COMP_WORDS[1]} words=\n"
        "    if ((COMP_CWORD == 1)); then\n";
    std::vector<std::string> first = commandNamesOf(app);
    const std::vector<std::string> scenes = sceneNames();
    first.insert(first.end(), scenes.begin(), scenes.end());
    text += fmt::format("        words={}\n    else\n        case $before in\n", wordList(first));
    for (const auto& [names, values] : listedValues(app))
        text += fmt::format("        {}) mapfile -t COMPREPLY < <(compgen -W {} -- \"$word\"); return ;;\n", names,
                            wordList(values));
    text += "        esac\n        case $command in\n";
    for (const CLI::App* command : commandsOf(app))
        text += fmt::format("        {}) words={} ;;\n", command->get_name(), wordList(allNames(*command)));
    text += fmt::format(
        "        help) words={} ;;\n        esac\n        [[ $word == -* || $command == help ]] || words={}\n    fi\n"
        "    mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\"; compgen -f -- \"$word\")\n}}\n"
        "complete -o filenames -F _timeshade timeshade\n",
        wordList(commandNamesOf(app)), wordList(scenes));
    return text;
}

/// In single quotes, as zsh and fish take them.
std::string quoted(const std::string& text) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

std::string fishOf(const CLI::App& app) {
    std::string text = "# Completion of fish for timeshade; made by `timeshade help --completion fish`.\n";
    for (const CLI::App* command : commandsOf(app)) {
        text += fmt::format("complete -c timeshade -n __fish_use_subcommand -a {} -d {}\n", command->get_name(),
                            quoted(command->get_description()));
        for (const CLI::Option* option : optionsOf(*command)) {
            text += fmt::format("complete -c timeshade -n '__fish_seen_subcommand_from {}'", command->get_name());
            for (const std::string& name : option->get_snames()) text += " -s " + name;
            for (const std::string& name : option->get_lnames()) text += " -l " + name;
            const std::vector<std::string> values = valuesOf(*option);
            if (!values.empty())
                text += fmt::format(" -x -a {}", quoted(fmt::format("{}", fmt::join(values, " "))));
            else if (!valueNameOf(*option).empty())
                text += " -r";
            text += fmt::format(" -d {}\n", quoted(option->get_description()));
        }
    }
    return text + fmt::format("complete -c timeshade -a {}\n", quoted(fmt::format("{}", fmt::join(sceneNames(), " "))));
}

/// Of zsh: what stands in brackets and between colons.
std::string forZsh(const std::string& text) {
    std::string safe;
    for (const char c : text) safe += (c == '[' || c == ']' || c == ':') ? std::string("\\") + c : std::string(1, c);
    return safe;
}

std::string zshOf(const CLI::App& app) {
    std::string text =
        "#compdef timeshade\n# Completion of zsh for timeshade; made by `timeshade help --completion zsh`.\n"
        "local -a commands=(";
    for (const CLI::App* command : commandsOf(app))
        text += " " + quoted(command->get_name() + ":" + forZsh(command->get_description()));
    text += fmt::format(
        ")\nif ((CURRENT == 2)); then\n    _describe command commands\n    compadd -- {}\n    _files\n    return\nfi\n"
        "case $words[2] in\n",
        fmt::join(sceneNames(), " "));
    for (const CLI::App* command : commandsOf(app)) {
        text += fmt::format("{}) _arguments -s", command->get_name());
        for (const CLI::Option* option : optionsOf(*command)) {
            const std::vector<std::string> values = valuesOf(*option);
            const std::string takes = valueNameOf(*option);
            for (const std::string& name : namesOf(*option)) {
                std::string word = name + "[" + forZsh(option->get_description()) + "]";
                if (!takes.empty())
                    word +=
                        ":" + takes + ":" + (values.empty() ? "_files" : fmt::format("({})", fmt::join(values, " ")));
                text += " \\\n    " + quoted("*" + word);
            }
        }
        text += " \\\n    '*:scene:_files'\n    ;;\n";
    }
    return text + "esac\n";
}

}  // namespace

std::string manualOf(const CLI::App& app) {
    std::string text = manualHead;
    text += ".SH COMMANDS\n";
    for (const CLI::App* command : commandsOf(app))
        text += fmt::format(".TP\n.B {}\n{}\n", command->get_name(), forManual(command->get_description()));
    text += ".TP\n.B help\nlists commands; with one of them, its options.\n";
    for (const CLI::App* command : commandsOf(app)) {
        text += fmt::format(".SH OPTIONS OF {}\n", command->get_name());
        for (const CLI::Option* option : optionsOf(*command)) text += manualOfOption(*option);
    }
    text += ".SH EXAMPLES\n";
    for (const CommandExample& example : commandExamples())
        text += fmt::format(".TP\n.B {}\n{}\n", forManual(example.line), forManual(example.what));
    return text + manualEnd;
}

std::string completionOf(const CLI::App& app, const std::string& shell) {
    if (shell == "zsh") return zshOf(app);
    return shell == "fish" ? fishOf(app) : bashOf(app);
}

void addHelpCommand(CLI::App& app) {
    enum class Shell { Bash, Zsh, Fish };
    struct Wanted {
        bool manual = false;
        std::optional<Shell> shell;
    };
    const auto wanted = std::make_shared<Wanted>();
    CLI::App* help = app.add_subcommand("help", "the options of a command: timeshade help shot");
    help->add_flag("--man", wanted->manual, "print the manual page");
    help->add_option("--completion", wanted->shell, "print what a shell completes commands with")
        ->transform(oneOf<Shell>({{"bash", Shell::Bash}, {"zsh", Shell::Zsh}, {"fish", Shell::Fish}}));
    help->final_callback([&app, wanted] {
        constexpr const char* shells[] = {"bash", "zsh", "fish"};
        const std::string text = wanted->manual  ? manualOf(app)
                                 : wanted->shell ? completionOf(app, shells[static_cast<int>(*wanted->shell)])
                                                 : app.help();
        fmt::print("{}", text);
        std::exit(std::fflush(stdout) == 0 ? 0 : 1);
    });
}

}  // namespace timeshade
