#pragma once

#include <algorithm>
#include <charconv>
#include <optional>
#include <string>

#include <glm/glm.hpp>

namespace timeshade {

inline constexpr int minimumMapSide = 16;
inline constexpr int maximumMapSide = 8192;

/// Texels of a shadow map. Whatever their numbers, the map covers the same part of the light: the texels of a map that
/// is not square are not square either.
struct MapSize {
    int width = 1024, height = 1024;  ///< minimumMapSide .. maximumMapSide each where a user chooses them

    constexpr MapSize() = default;
    constexpr MapSize(int side) : width(side), height(side) {}  // NOLINT: a number means a square
    constexpr MapSize(int width_, int height_) : width(width_), height(height_) {}

    bool isSquare() const { return width == height; }
    int longerSide() const { return std::max(width, height); }
    int shorterSide() const { return std::min(width, height); }
    std::size_t texels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
    glm::dvec2 sides() const { return {width, height}; }
    bool operator==(const MapSize&) const = default;
    auto operator<=>(const MapSize&) const = default;

    /// "1024" or "1024x768", as --map takes it.
    std::string text() const {
        return isSquare() ? std::to_string(width) : std::to_string(width) + "x" + std::to_string(height);
    }
    /// Nothing where the text is no size, or a side is out of range.
    static std::optional<MapSize> of(const std::string& text) {
        const std::size_t x = text.find('x');
        const auto side = [](const std::string& digits) {
            int number = 0;
            const char* end = digits.data() + digits.size();
            const auto [rest, failure] = std::from_chars(digits.data(), end, number);
            const bool good = failure == std::errc{} && rest == end && number >= minimumMapSide;
            return good && number <= maximumMapSide ? number : 0;
        };
        const int width = side(text.substr(0, x)), height = x == std::string::npos ? width : side(text.substr(x + 1));
        return width > 0 && height > 0 ? std::optional(MapSize(width, height)) : std::nullopt;
    }
};

}  // namespace timeshade
