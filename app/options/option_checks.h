#pragma once

#include <charconv>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "plan/map_size.h"

namespace timeshade {

/// Checks of values, our own: CLI11's ranges let NaN pass, its words may also be given as numbers, and the messages of
/// both leave out what was expected or say more than that.
template <typename T>
CLI::Validator numberFrom(T low, T high) {
    return CLI::Validator(
        [low, high](const std::string& text) {
            T number{};
            const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
            const bool good =
                failure == std::errc{} && rest == text.data() + text.size() && number >= low && number <= high;
            return good ? std::string{}
                        : fmt::format("'{}' given, expected a {} from {} to {}", text,
                                      std::is_integral_v<T> ? "whole number" : "number", low, high);
        },
        fmt::format("{} to {}", low, high));
}

inline CLI::Validator notEmpty(const std::string& expected) {
    return CLI::Validator(
        [expected](const std::string& text) { return text.empty() ? "'' given, expected " + expected : ""; }, "");
}

/// The words with bars between them: what kind of value an option takes, for help and completion.
template <typename Enum>
std::string wordsOf(const std::vector<std::pair<std::string, Enum>>& words) {
    std::string all;
    for (const auto& [word, value] : words) all += (all.empty() ? "" : "|") + word;
    return all;
}

/// Replaces a word by its enumerator's number, which is how CLI11 reads enumerations.
template <typename Enum>
CLI::Validator oneOf(const std::vector<std::pair<std::string, Enum>>& words) {
    return CLI::Validator(
        [words](std::string& text) {
            std::string known;
            for (const auto& [word, value] : words) {
                if (word == text) {
                    text = std::to_string(static_cast<int>(value));
                    return std::string{};
                }
                known += (known.empty() ? "" : ", ") + word;
            }
            return fmt::format("'{}' given, expected one of {}", text, known);
        },
        wordsOf(words));
}

/// An option of which the last one counts.
template <typename Enum>
CLI::Option* addChoice(CLI::App& app, const std::string& name, Enum& value,
                       const std::vector<std::pair<std::string, Enum>>& words, const std::string& help) {
    CLI::Option* option = app.add_option(name, value, help)->transform(oneOf<Enum>(words));
    for (const auto& [word, meaning] : words)
        if (meaning == value) option->default_str(word);
    return option->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

/// Of an option that stands in a settings file and on the command line, or twice, the last counts.
inline constexpr auto lastWins = CLI::MultiOptionPolicy::TakeLast;

void declareSamples(CLI::App& app, int& samplesPerPixel);
/// Texels along a side, or WIDTHxHEIGHT.
CLI::Validator mapSizeText();
void declareMapSize(CLI::App& app, MapSize& mapSize, const std::string& help);
/// Names of built-in scenes, and that a file may be given too.
CLI::Option* declareScene(CLI::App& app, std::string& scene);

}  // namespace timeshade
