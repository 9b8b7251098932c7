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

/// Where data of these values lie; a narrow range is widened around its middle to most of a decade. Values without
/// a logarithm are not asked for.
struct LogRange {
    double low = -1.0;
    double high = 1.0;
};
LogRange logRangeOf(const std::vector<double>& values);

/// The ticks that an axis has room for: at every decade or every few, labels `spacing` pixels apart or more; where
/// decades are wide, lines at 2 to 9 and labels at some of them. At least two labels are on every axis that is
/// widened as above and has room for them.
std::vector<ChartTick> ticksOf(const ChartAxis& axis, double spacing);

/// 0.02 and 3000; from 10⁶ and below 10⁻⁴ as powers.
std::string tickLabel(int mantissa, int exponent);

}  // namespace timeshade
