#pragma once

#include <charconv>
#include <optional>
#include <string>
#include <vector>

namespace timeshade {

/// Numbers with commas between them; nothing where the text is anything else. May be infinite or NaN.
template <typename T>
std::optional<std::vector<T>> numbersIn(const std::string& text) {
    std::vector<T> numbers;
    const char *at = text.data(), *end = at + text.size();
    for (;;) {
        T number{};
        const auto [rest, failure] = std::from_chars(at, end, number);
        if (failure != std::errc{}) return std::nullopt;
        numbers.push_back(number);
        at = rest;
        if (at == end) return numbers;
        if (*at++ != ',') return std::nullopt;
    }
}

/// The same, of so many numbers.
template <typename T>
std::optional<std::vector<T>> numbersIn(const std::string& text, std::size_t count) {
    std::optional<std::vector<T>> numbers = numbersIn<T>(text);
    return numbers && numbers->size() == count ? numbers : std::nullopt;
}

}  // namespace timeshade
