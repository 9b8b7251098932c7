#pragma once

#include "image/image_file.h"

#include <string>
#include <vector>

namespace timeshade {

struct ChartPoint {
    double x = 0.0;
    double y = 0.0;
    std::string label;  ///< written beside the marker where there is room; may be empty
};

/// One curve: markers joined in the order given. The name is drawn at the last point.
struct ChartSeries {
    std::string name;
    std::vector<ChartPoint> points;
};

/// A line of this slope in the log-log plane, to compare the steepness of curves with. Drawn where there is room.
struct ChartSlope {
    double slope = -0.5;
    std::string label;
};

/// A chart with two logarithmic axes. Any text may be empty; all of it is UTF-8. Points that have no logarithm (0,
/// negative, not finite) are not drawn; the footnote says how many and of which series.
struct Chart {
    std::string title;
    std::string subtitle;
    std::string xLabel;
    std::string yLabel;
    std::vector<ChartSeries> series;
    std::vector<ChartSlope> slopes;
    bool drawParetoFront =
        false;  ///< a pale line behind the curves through the Pareto front: no other point is better in both
    std::string footnote;
};

/// Draws the chart into width x height pixels; `scale` multiplies every length in it, letters included (2 for twice
/// as many pixels of the same chart). Equal charts give equal pixels. Throws Error where the picture is too small to
/// hold a chart (320x240 times scale) or too large, or where a font file is missing.
DisplayImage drawChart(const Chart& chart, int width, int height, double scale = 1.0);

}  // namespace timeshade
