#include "chart/chart.h"

#include "chart/chart_canvas.h"
#include "chart/chart_layout.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace timeshade {
namespace {

constexpr Rgb paper = {255, 255, 255};
constexpr Rgb plotGround = {250, 251, 252};
constexpr Rgb decadeLine = {214, 219, 226};
constexpr Rgb fineLine = {235, 238, 242};
constexpr Rgb axisLine = {120, 126, 136};
constexpr Rgb slopeLine = {150, 156, 166};
constexpr Rgb paretoLine = {255, 224, 140};

/// Draws a layout from back to front.
class Painter {
  public:
    Painter(const ChartLayout& layout, const ChartFonts& fonts, int width, int height)
        : layout_(layout), fonts_(fonts), canvas_(width, height, paper) {}

    DisplayImage paint() {
        grid();
        slopes();
        const ChartStroke pareto{px(11.0), paretoLine, 0.85, 0.0};
        canvas_.drawLine(layout_.paretoFront, pareto);
        canvas_.drawLine(layout_.paretoSample, pareto);
        for (const PlacedSeries& series : layout_.series) {
            canvas_.drawLine(series.leader, {px(0.8), series.color, 0.6, 0.0});
        }
        curves();
        for (const PlacedText& text : layout_.texts) {
            write(text, false);
        }
        for (const PlacedSeries& series : layout_.series) {
            for (const PlacedText& label : series.labels) {
                write(label, true);
            }
            if (series.name) {
                write(*series.name, true);
            }
        }
        return canvas_.picture();
    }

  private:
    double px(double length) const { return length * layout_.scale; }

    /// Grid lines are at whole pixels, so that all look the same.
    double thickness() const { return std::max(1.0, std::round(layout_.scale)); }

    void grid() {
        const PixelBox& plot = layout_.plot;
        canvas_.fillBox(plot, plotGround);
        // Fine lines first, decades over them.
        for (const bool decade : {false, true}) {
            const Rgb color = decade ? decadeLine : fineLine;
            for (const ChartTick& tick : layout_.x.ticks) {
                const double x = std::floor(layout_.x.pixelOf(tick.value));
                if (tick.decade == decade) {
                    canvas_.fillBox({x, plot.top, x + thickness(), plot.bottom}, color);
                }
            }
            for (const ChartTick& tick : layout_.y.ticks) {
                const double y = std::floor(layout_.y.pixelOf(tick.value));
                if (tick.decade == decade) {
                    canvas_.fillBox({plot.left, y, plot.right, y + thickness()}, color);
                }
            }
        }
        const double left = std::floor(plot.left);
        const double bottom = std::floor(plot.bottom);
        canvas_.fillBox({left, plot.top, left + thickness(), bottom + thickness()}, axisLine);
        canvas_.fillBox({left, bottom, plot.right, bottom + thickness()}, axisLine);
        labelledTicks(left, bottom);
    }

    void labelledTicks(double left, double bottom) {
        for (const ChartTick& tick : layout_.x.ticks) {
            const double x = std::floor(layout_.x.pixelOf(tick.value));
            if (!tick.label.empty()) {
                canvas_.fillBox({x, bottom, x + thickness(), bottom + px(5.0)}, axisLine);
            }
        }
        for (const ChartTick& tick : layout_.y.ticks) {
            const double y = std::floor(layout_.y.pixelOf(tick.value));
            if (!tick.label.empty()) {
                canvas_.fillBox({left - px(5.0), y, left, y + thickness()}, axisLine);
            }
        }
    }

    void slopes() {
        for (const PlacedSlope& slope : layout_.slopes) {
            const std::array<PixelPoint, 2> line = {slope.from, slope.to};
            canvas_.drawLine(line, {px(1.4), slopeLine, 1.0, px(4.0)});
            write(slope.label, true);
        }
    }

    void curves() {
        std::vector<PixelPoint> line;
        for (const PlacedSeries& series : layout_.series) {
            line.clear();
            for (const PlacedPoint& point : series.points) {
                line.push_back(point.pixel);
            }
            canvas_.drawLine(line, {px(2.2), series.color, 1.0, 0.0});
        }
        for (const PlacedSeries& series : layout_.series) {
            for (const PlacedPoint& point : series.points) {
                // A rim in the background's colour separates markers that overlap.
                marker(series.marker, point.pixel, layout_.markerRadius() + px(1.5), paper);
                marker(series.marker, point.pixel, layout_.markerRadius(), series.color);
            }
        }
    }

    /// All kinds have about the area of a disc of this radius.
    void marker(ChartMarker kind, PixelPoint p, double radius, Rgb color) {
        const double half = radius * 0.88;
        const double wide = radius * 1.22;
        const double up = radius * 1.25;
        const double down = radius * 0.80;
        switch (kind) {
        case ChartMarker::disc: canvas_.fillDisc(p, radius, color); break;
        case ChartMarker::square: fill(p, {{{-half, -half}, {half, -half}, {half, half}, {-half, half}}}, color); break;
        case ChartMarker::diamond: fill(p, {{{0.0, -wide}, {wide, 0.0}, {0.0, wide}, {-wide, 0.0}}}, color); break;
        case ChartMarker::triangleUp: fill(p, {{{0.0, -up}, {wide, down}, {-wide, down}}}, color); break;
        case ChartMarker::triangleDown: fill(p, {{{0.0, up}, {wide, -down}, {-wide, -down}}}, color); break;
        }
    }

    void fill(PixelPoint centre, std::vector<PixelPoint> corners, Rgb color) {
        for (PixelPoint& corner : corners) {
            corner = {corner.x + centre.x, corner.y + centre.y};
        }
        canvas_.fillConvex(corners, color);
    }

    void write(const PlacedText& text, bool halo) {
        const ChartFont& font = fonts_.of(text.bold);
        CoverageMask mask = font.render(text.text, text.size, text.baseline.x, text.baseline.y);
        if (text.vertical) {
            mask = turnedLeft(mask, static_cast<int>(std::lround(text.baseline.x)),
                              static_cast<int>(std::lround(text.baseline.y)));
        }
        if (halo) {
            canvas_.drawMask(dilated(mask, px(2.0)), plotGround, 0.85);
        }
        canvas_.drawMask(mask, text.color);
    }

    const ChartLayout& layout_;
    const ChartFonts& fonts_;
    ChartCanvas canvas_;
};

}  // namespace

DisplayImage drawChart(const Chart& chart, int width, int height, double scale) {
    const ChartFonts fonts;
    const ChartLayout layout = layoutChart(chart, fonts, width, height, scale);
    return Painter(layout, fonts, width, height).paint();
}

}  // namespace timeshade
