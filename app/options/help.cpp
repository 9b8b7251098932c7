#include "options/help.h"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace timeshade {

namespace {

constexpr std::size_t lineWidth = 100;  // columns

/// Text in lines behind a column; the first line begins where `used` columns are taken.
std::string inColumn(const std::string& text, std::size_t column, std::size_t used) {
    std::string lines;
    std::size_t at = used;
    const auto begin = [&] {
        lines += at + 1 > column ? "\n" + std::string(column, ' ') : std::string(column - at, ' ');
        at = column;
    };
    begin();
    std::istringstream words(text);
    bool first = true;
    for (std::string word; words >> word; first = false) {
        if (!first && at + 1 + word.size() > lineWidth) {
            lines += "\n" + std::string(column, ' ');
            at = column;
            first = true;
        }
        lines += (first ? "" : " ") + word;
        at += word.size() + (first ? 0 : 1);
    }
    return lines + "\n";
}

/// What stands behind the colon of CLI11's name of a type: "1 to 32", "auto|on|off".
std::string limitsOf(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t colon = type.find(':');
    return colon == std::string::npos ? "" : type.substr(colon + 1);
}

}  // namespace

std::string descriptionOf(const CLI::Option& option) {
    std::string text = option.get_description();
    const std::vector<std::string> words = wordsOf(option);
    std::vector<std::string> facts;
    if (option.get_required()) facts.push_back("required");
    if (!words.empty() && text.find(words.front()) == std::string::npos)
        facts.push_back(fmt::format("{}", fmt::join(words, ", ")));
    if (words.empty() && !limitsOf(option).empty()) facts.push_back(limitsOf(option));
    if (!option.get_default_str().empty() && text.find("default") == std::string::npos)
        facts.push_back("default: " + option.get_default_str());
    if (!facts.empty()) text += fmt::format(" ({})", fmt::join(facts, "; "));
    return text;
}

std::string valueNameOf(const CLI::Option& option) {
    if (option.get_type_size() == 0 || option.get_expected_max() == 0) return "";
    const std::string type = option.get_type_name(), kind = type.substr(0, type.find(':'));
    const std::string one = !wordsOf(option).empty()          ? "WORD"
                            : kind == "INT" || kind == "UINT" ? "N"
                            : kind == "FLOAT"                 ? "X"
                                                              : "TEXT";
    return option.get_expected_max() == CLI::detail::expected_max_vector_size ? one + ",..." : one;
}

std::vector<std::string> wordsOf(const CLI::Option& option) {
    const std::string limits = limitsOf(option);
    if (limits.find('|') == std::string::npos) return {};
    std::vector<std::string> words;
    std::istringstream all(limits);
    for (std::string word; std::getline(all, word, '|');) words.push_back(word);
    return words;
}

std::string HelpFormatter::make_option(const CLI::Option* option, bool isPositional) const {
    std::string name = "  " + make_option_name(option, isPositional);
    for (std::size_t comma = name.find(','); comma != std::string::npos; comma = name.find(',', comma + 2))
        name.insert(comma + 1, " ");
    const std::string takes = valueNameOf(*option);
    if (!isPositional && !takes.empty()) name += " " + takes;
    return name + inColumn(descriptionOf(*option), get_column_width(), name.size());
}

std::string HelpFormatter::make_group(std::string group, bool isPositional,
                                      std::vector<const CLI::Option*> options) const {
    std::string text = "\n" + group + ":\n";
    for (const CLI::Option* option : options) text += make_option(option, isPositional);
    return text;
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
    const std::string name = "  " + command->get_name();
    return name + inColumn(command->get_description(), 14, name.size());
}

std::string HelpFormatter::make_usage(const CLI::App* app, std::string name) const {
    if (app->get_parent() == nullptr) return "\nUsage: timeshade [COMMAND] [SCENE] [OPTIONS]\n";
    return "\n" + CLI::Formatter::make_usage(app, std::move(name));
}

const std::vector<CommandExample>& commandExamples() {
    static const std::vector<CommandExample> examples{
        {"view", "timeshade my_model.glb", "a model of one's own in the window"},
        {"view", "timeshade view cubes --technique exact --set cubes.count=2000", "a computed scene"},
        {"shot", "timeshade shot chess --technique exact --spp 16 -o chess.png", "one picture"},
        {"shot", "timeshade shot my_model.glb --light-direction 40,35 --light-move 0.5,0,0 -o moved.png",
         "with a light that moves"},
        {"shot", "timeshade shot chess -o - | display", "to another program"},
        {"record", "timeshade record chess --fps 24000/1001 --frames 96 -o chess.mp4", "a video"},
        {"record", "timeshade record --demo -o tour.mp4", "the tour of scenes and techniques"},
        {"pictures", "timeshade pictures --technique exact -o pictures", "every built-in scene"},
        {"verify", "timeshade verify chess --technique exact --max-ppm 10", "exit code 3 where more disagree"},
        {"measure", "timeshade measure chess --techniques tsm,exact --spps 2,4,8 -o measured", "tables and charts"},
        {"measure", "timeshade measure chess --equal-time exact,tsm -o equal", "pictures that take as long"},
        {"epipolar", "timeshade epipolar crossing --technique exact --row 0.5 -o line.png", "a row of the map"},
        {"reproduce", "timeshade reproduce hong2019 --quick -o hong2019", "every figure of a paper; open index.html"},
        {"reproduce", "timeshade reproduce scherzer2007 3 5 -o scherzer2007", "two of them"},
        {"cases", "timeshade cases --techniques tsm,exact -o cases.png", "against exact answers"},
        {"list", "timeshade list --json", "all scenes, techniques and settings, for a program"},
    };
    return examples;
}

std::string examplesOf(const std::string& command) {
    std::string text;
    for (const CommandExample& example : commandExamples())
        if (example.command == command) text += fmt::format("  {}\n      {}\n", example.line, example.what);
    return text.empty() ? "" : "Examples:\n" + text;
}

}  // namespace timeshade
