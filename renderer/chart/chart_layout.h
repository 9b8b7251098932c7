#pragma once

#include "chart/chart.h"
#include "chart/chart_axis.h"
#include "chart/chart_font.h"
#include "chart/chart_geometry.h"

#include <optional>
#include <string>
#include <vector>

namespace timeshade {

struct PlacedText {
    std::string text;
    PixelPoint baseline;  ///< start of the first letter; vertical text runs upwards from there
    PixelBox box;         ///< contains all letters
    double size = 12.0;   ///< pixels per em
    Rgb color;
    bool bold = false;
    bool vertical = false;
};

enum class ChartMarker { disc, square, diamond, triangleUp, triangleDown };

struct PlacedPoint {
    std::size_t index = 0;  ///< of the point in its ChartSeries; points that are not drawn are left out
    PixelPoint pixel;       ///< centre of its marker
};

struct PlacedSeries {
    Rgb color;
    ChartMarker marker = ChartMarker::disc;
    std::vector<PlacedPoint> points;
    std::optional<PlacedText> name;  ///< none without points
    std::vector<PixelPoint> leader;  ///< a thin line from the last point to a name that is not beside it
    std::vector<PlacedText> labels;  ///< labels of points for which there was room
};

struct PlacedSlope {
    PixelPoint from;
    PixelPoint to;
    PlacedText label;
};

/// The position of everything in a chart. Tests check it as numbers.
struct ChartLayout {
    double scale = 1.0;
    PixelBox plot;
    ChartAxis x;
    ChartAxis y;
    std::vector<PlacedSeries> series;  ///< in the chart's order
    std::vector<PixelPoint> paretoFront;
    std::vector<PixelPoint> paretoSample;  ///< a piece of the front's line before its name, as in a legend
    std::vector<PlacedSlope> slopes;
    std::vector<PlacedText> texts;  ///< all others: title, axes, ticks, footnote
    std::string footnote;           ///< the chart's own and what was not drawn

    PixelPoint pixelOf(const ChartPoint& point) const { return {x.pixelOf(point.x), y.pixelOf(point.y)}; }
    double markerRadius() const { return 5.0 * scale; }
};

/// Throws Error as drawChart does.
ChartLayout layoutChart(const Chart& chart, const ChartFonts& fonts, int width, int height, double scale = 1.0);

/// The Pareto front: the points for which no other is at least as good in both x and y (less is better) and better in
/// one. From left to right; equal points count once; points that cannot be drawn are left out.
std::vector<ChartPoint> paretoFrontOf(const Chart& chart);

/// Whether the point can be drawn on logarithmic axes.
bool isDrawable(const ChartPoint& point);

}  // namespace timeshade
