#pragma once

#include <string>
#include <vector>

namespace timeshade {

struct ChartTick {
    double value = 0.0;
    std::string label;    ///< empty: only a line of the grid
    bool decade = false;  ///< a power of ten
};

/// A logarithmic axis: which pixel shows which value. Pixels may run against values, as they do upwards.
struct ChartAxis {
    double lowLog = -1.0;  ///< log10 of the value at pixelLow
    double highLog = 1.0;
    double pixelLow = 0.0;
    double pixelHigh = 1.0;
    std::vector<ChartTick> ticks;

    double pixelOf(double value) const;
    double valueOf(double pixel) const;
    double pixelsPerDecade() const;
};

/// log10 of the smallest and largest value; a narrow range is widened around its centre to most of a decade. All values
/// must be positive and finite.
struct LogRange {
    double low = -1.0;
    double high = 1.0;
};
LogRange logRangeOf(const std::vector<double>& values);

/// The ticks that fit an axis: at every decade or every few, labels at least `spacing` pixels apart; where decades are
/// wide, also lines at 2 to 9 and labels at some of them. An axis that is widened as above has at least two labels if
/// it has room for them.
std::vector<ChartTick> ticksOf(const ChartAxis& axis, double spacing);

/// 0.02 and 3000; from 10⁶ and below 10⁻⁴ as powers.
std::string tickLabel(int mantissa, int exponent);

}  // namespace timeshade
