#include "chart/chart_axis.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <span>

namespace timeshade {
namespace {

/// A single value, or equal ones, still get an axis with labels.
constexpr double narrowestRange = 0.7;

std::string superscript(int number) {
    constexpr std::array<const char*, 10> digits = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string text = number < 0 ? "⁻" : "";
    for (const char digit : std::to_string(std::abs(number))) {
        text += digits[static_cast<std::size_t>(digit - '0')];
    }
    return text;
}

/// Which multiples of a power of ten are labelled: as many as are far enough apart.
std::span<const int> labelledMantissas(double pixelsPerDecade, double spacing) {
    static constexpr std::array<int, 5> many = {1, 2, 3, 5, 7};
    static constexpr std::array<int, 3> some = {1, 2, 5};
    static constexpr std::array<int, 1> few = {1};
    // The closest of each set: 5 and 7, 1 and 2.
    if (pixelsPerDecade * std::log10(7.0 / 5.0) >= spacing * 1.2) {
        return many;
    }
    if (pixelsPerDecade * std::log10(2.0) >= spacing * 1.2) {
        return some;
    }
    return few;
}

}  // namespace

double ChartAxis::pixelOf(double value) const {
    return pixelLow + (std::log10(value) - lowLog) / (highLog - lowLog) * (pixelHigh - pixelLow);
}

double ChartAxis::valueOf(double pixel) const {
    return std::pow(10.0, lowLog + (pixel - pixelLow) / (pixelHigh - pixelLow) * (highLog - lowLog));
}

double ChartAxis::pixelsPerDecade() const { return std::abs(pixelHigh - pixelLow) / (highLog - lowLog); }

LogRange logRangeOf(const std::vector<double>& values) {
    if (values.empty()) {
        return {};
    }
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    LogRange range{std::log10(*least), std::log10(*greatest)};
    const double missing = narrowestRange - (range.high - range.low);
    if (missing > 0.0) {
        range.low -= missing / 2.0;
        range.high += missing / 2.0;
    }
    return range;
}

std::string tickLabel(int mantissa, int exponent) {
    if (exponent >= 0 && exponent < 6) {
        return std::to_string(mantissa) + std::string(static_cast<std::size_t>(exponent), '0');
    }
    if (exponent < 0 && exponent >= -4) {
        return "0." + std::string(static_cast<std::size_t>(-exponent - 1), '0') + std::to_string(mantissa);
    }
    return (mantissa == 1 ? "10" : fmt::format("{}×10", mantissa)) + superscript(exponent);
}

std::vector<ChartTick> ticksOf(const ChartAxis& axis, double spacing) {
    const double pixels = axis.pixelsPerDecade();
    int step = 1;
    for (const int wider : {2, 5, 10, 20, 50, 100, 200}) {
        step = pixels * step < spacing ? wider : step;
    }
    const bool fine = step == 1 && pixels >= 1.5 * spacing;
    const std::span<const int> labelled = labelledMantissas(pixels, spacing);

    std::vector<ChartTick> ticks;
    const int first = static_cast<int>(std::floor(axis.lowLog));
    const int last = static_cast<int>(std::floor(axis.highLog));
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % step != 0) {
            continue;
        }
        for (int mantissa = 1; mantissa <= (fine ? 9 : 1); ++mantissa) {
            const double log = exponent + std::log10(mantissa);
            if (log < axis.lowLog || log > axis.highLog) {
                continue;
            }
            const bool isLabelled = std::find(labelled.begin(), labelled.end(), mantissa) != labelled.end();
            // Parsing "1e-2" gives the double nearest to 0.01, which a product with a power may miss.
            const double value = std::strtod(fmt::format("{}e{}", mantissa, exponent).c_str(), nullptr);
            if (value == 0.0 || std::isinf(value)) {
                continue;  // the margin of an axis may exceed the largest double
            }
            ticks.push_back({value, isLabelled ? tickLabel(mantissa, exponent) : "", mantissa == 1});
        }
    }
    return ticks;
}

}  // namespace timeshade
