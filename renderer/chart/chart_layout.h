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
    PixelPoint baseline;  ///< where its first letter starts; a vertical text runs upwards from there
    PixelBox box;         ///< what its letters stay inside of
    double size = 12.0;   ///< pixels per em
    Rgb color;
    bool bold = false;
    bool vertical = false;
};

enum class ChartMarker { disc, square, diamond, triangleUp, triangleDown };

struct PlacedPoint {
    std::size_t index = 0;  ///< of the point in its ChartSeries; points that are not drawn are missing here
    PixelPoint pixel;       ///< centre of its marker
};

struct PlacedSeries {
    Rgb color;
    ChartMarker marker = ChartMarker::disc;
    std::vector<PlacedPoint> points;
    std::optional<PlacedText> name;  ///< none without points
    std::vector<PixelPoint> leader;  ///< a thin line from the last point to a name that stands apart from it
    std::vector<PlacedText> labels;  ///< those of the points that there was room for
};

struct PlacedSlope {
    PixelPoint from;
    PixelPoint to;
    PlacedText label;
};

/// Where everything in a chart goes: the part of drawing that can be checked with numbers.
struct ChartLayout {
    double scale = 1.0;
    PixelBox plot;
    ChartAxis x;
    ChartAxis y;
    std::vector<PlacedSeries> series;  ///< as many as in the chart, in its order
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

/// The points that no other point beats: none is as good in both x and y (less is better) and better in one.
/// From left to right; points with equal values count once. Points that cannot be drawn take no part.
std::vector<ChartPoint> paretoFrontOf(const Chart& chart);

/// Can this point be on logarithmic axes?
bool isDrawable(const ChartPoint& point);

}  // namespace timeshade
