#include "chart/chart_layout.h"

#include "chart/chart_labels.h"
#include "core/error.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace timeshade {
namespace {

constexpr Rgb dark = {32, 36, 43};
constexpr Rgb grey = {96, 102, 112};

// Told apart by people with any kind of colour blindness: seven of Okabe and Ito (2008), whose yellow is too pale
// for a line on white, and three of Tol's "muted" scheme (2021). Markers and names tell curves apart as well.
constexpr std::array<Rgb, 10> palette = {{{0, 114, 178},
                                          {213, 94, 0},
                                          {0, 158, 115},
                                          {204, 121, 167},
                                          {230, 159, 0},
                                          {86, 180, 233},
                                          {40, 40, 40},
                                          {136, 34, 85},
                                          {153, 153, 51},
                                          {51, 34, 136}}};
constexpr std::size_t markerKinds = 5;

constexpr double smallestWidth = 320.0;
constexpr double smallestHeight = 240.0;
constexpr int largestSide = 16384;

void requireSize(int width, int height, double scale) {
    const bool sensible = std::isfinite(scale) && scale >= 0.5 && scale <= 16.0;
    if (!sensible) {
        throw Error(fmt::format("cannot draw a chart at scale {}, expected 0.5 to 16", scale));
    }
    if (width < smallestWidth * scale || height < smallestHeight * scale || std::max(width, height) > largestSide) {
        throw Error(fmt::format("cannot draw a chart of {}x{} pixels, expected from {:.0f}x{:.0f} to {}x{}", width,
                                height, std::ceil(smallestWidth * scale), std::ceil(smallestHeight * scale),
                                largestSide, largestSide));
    }
}

/// "3 values at 0 not shown (exact, embree)", counted over all series; empty where there are none.
template <class Predicate>
std::string describeMissing(const Chart& chart, const char* what, const Predicate& isSo) {
    std::size_t count = 0;
    std::vector<std::string> names;
    for (const ChartSeries& series : chart.series) {
        const auto found = std::count_if(series.points.begin(), series.points.end(), isSo);
        count += static_cast<std::size_t>(found);
        if (found > 0 && std::find(names.begin(), names.end(), series.name) == names.end()) {
            names.push_back(series.name);
        }
    }
    if (count == 0) {
        return "";
    }
    return fmt::format("{} value{} {} not shown ({})", count, count == 1 ? "" : "s", what, fmt::join(names, ", "));
}

bool isAtZero(const ChartPoint& point) {
    return (point.x == 0.0 || point.y == 0.0) && point.x >= 0.0 && point.y >= 0.0 && std::isfinite(point.x) &&
           std::isfinite(point.y);
}

std::string footnoteOf(const Chart& chart) {
    std::vector<std::string> parts = {chart.footnote, describeMissing(chart, "at 0", isAtZero),
                                      describeMissing(chart, "negative or not finite", [](const ChartPoint& point) {
                                          return !isDrawable(point) && !isAtZero(point);
                                      })};
    std::erase(parts, "");
    return fmt::format("{}", fmt::join(parts, " · "));
}

/// Builds a layout from the outside in.
class Builder {
  public:
    Builder(const Chart& chart, const ChartFonts& fonts, int width, int height, double scale)
        : chart_(chart), fonts_(fonts), width_(width), height_(height) {
        layout_.scale = scale;
        layout_.footnote = footnoteOf(chart);
    }

    ChartLayout build() {
        layout_.plot = {px(24.0), header(), width_ - px(28.0), footer()};
        vertical();
        horizontal();
        points();
        if (chart_.drawParetoFront) {
            pareto();
        }
        placeLabels(chart_, fonts_, layout_);
        return std::move(layout_);
    }

  private:
    double px(double length) const { return length * layout_.scale; }

    PlacedText& write(const std::string& text, PixelPoint baseline, double size, Rgb color, bool bold = false) {
        return layout_.texts.emplace_back(placeText(fonts_, text, baseline, {px(size), color, bold}));
    }

    /// The lines of text that leave room for the plot: at least one.
    std::vector<std::string> wrapped(const std::string& text, double size, double room, double most) const {
        std::vector<std::string> lines = fonts_.regular.wrap(text, px(size), room);
        const std::size_t limit = static_cast<std::size_t>(std::max(most, 1.0));
        if (lines.size() > limit) {
            lines.resize(limit);
            lines.back() += " …";
        }
        for (std::string& line : lines) {
            line = fonts_.regular.shorten(line, px(size), room);
        }
        return lines;
    }

    /// Places the title and the subtitle. Returns where the plot may start.
    double header() {
        const double room = width_ - px(24.0 + 28.0);
        double y = px(14.0);
        if (!chart_.title.empty()) {
            y += px(22.0);
            write(fonts_.bold.shorten(chart_.title, px(20.0), room), {px(24.0), y}, 20.0, dark, true);
        }
        const double legend = chart_.drawParetoFront ? px(150.0) : 0.0;
        for (const std::string& line : wrapped(chart_.subtitle, 13.0, room - legend, 0.12 * height_ / px(20.0))) {
            y += px(20.0);
            write(line, {px(24.0), y}, 13.0, grey);
        }
        if (chart_.drawParetoFront && chart_.subtitle.empty()) {
            y += px(20.0);
        }
        headerBaseline_ = y;
        return y + px(18.0);
    }

    /// Places the footnote and the horizontal axis's name, from the bottom up. Returns where the plot may end.
    double footer() {
        const std::vector<std::string> lines =
            wrapped(layout_.footnote, 11.0, width_ - px(24.0 + 28.0), 0.15 * height_ / px(15.0));
        double y = height_ - px(14.0);
        for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
            write(*line, {px(24.0), y}, 11.0, grey);
            y -= px(15.0);
        }
        y -= lines.empty() ? 0.0 : px(8.0);
        xLabelBaseline_ = y;
        return y - px(chart_.xLabel.empty() ? 22.0 : 44.0);
    }

    std::vector<double> drawn(double ChartPoint::*coordinate) const {
        std::vector<double> values;
        for (const ChartSeries& series : chart_.series) {
            for (const ChartPoint& point : series.points) {
                if (isDrawable(point)) {
                    values.push_back(point.*coordinate);
                }
            }
        }
        return values;
    }

    /// The margin between data and the edges of a plot of this width or height.
    double margin(double extent) const { return std::min(px(30.0), 0.15 * extent); }

    /// An axis with a margin of this many pixels between its data and the plot's edges.
    static ChartAxis axisOver(LogRange range, double pixelLow, double pixelHigh, double padLow, double padHigh) {
        const double decades = (range.high - range.low) / (std::abs(pixelHigh - pixelLow) - padLow - padHigh);
        return {range.low - padLow * decades, range.high + padHigh * decades, pixelLow, pixelHigh, {}};
    }

    void vertical() {
        PixelBox& plot = layout_.plot;
        const double pad = margin(plot.height());
        layout_.y = axisOver(logRangeOf(drawn(&ChartPoint::y)), plot.bottom, plot.top, pad, pad);
        layout_.y.ticks = ticksOf(layout_.y, px(24.0));
        double widest = 0.0;
        for (const ChartTick& tick : layout_.y.ticks) {
            widest = std::max(widest, fonts_.regular.width(tick.label, px(12.0)));
        }
        plot.left += widest + px(9.0) + (chart_.yLabel.empty() ? 0.0 : px(26.0));
        for (const ChartTick& tick : layout_.y.ticks) {
            const double y = layout_.y.pixelOf(tick.value) + fonts_.regular.capHeight(px(12.0)) / 2.0;
            const double x = plot.left - px(9.0) - fonts_.regular.width(tick.label, px(12.0));
            if (!tick.label.empty()) {
                write(tick.label, {x, y}, 12.0, grey);
            }
        }
        if (!chart_.yLabel.empty()) {
            nameVertical();
        }
    }

    void nameVertical() {
        // Beside the plot and, where that is too short, beside the names below it as well.
        const PixelBox& plot = layout_.plot;
        const double room = xLabelBaseline_ - plot.top;
        const double size = fonts_.regular.width(chart_.yLabel, px(13.0)) <= room ? 13.0 : 11.0;
        const std::string text = fonts_.regular.shorten(chart_.yLabel, px(size), room);
        const double length = fonts_.regular.width(text, px(size));
        const double start = std::max((plot.top + plot.bottom + length) / 2.0, plot.top + length);
        PlacedText& label = write(text, {px(24.0 + 11.0), start}, size, dark);
        label.vertical = true;
        label.box = {px(24.0), start - length, px(24.0 + 15.0), start};
    }

    /// The width that names need to the right of the data; each starts at the end of its curve.
    double roomForNames(LogRange range, double padLeft) const {
        const double width = layout_.plot.width();
        double pad = padLeft;
        for (const ChartSeries& series : chart_.series) {
            const auto last = std::find_if(series.points.rbegin(), series.points.rend(), isDrawable);
            if (last == series.points.rend()) {
                continue;
            }
            const double name = std::min(fonts_.bold.width(series.name, px(13.0)), 0.4 * width) + px(18.0);
            const double share = (std::log10(last->x) - range.low) / (range.high - range.low);
            if (share > 0.0) {
                pad = std::max(pad, width - padLeft - (width - padLeft - name) / share);
            }
        }
        return std::min(pad, 0.45 * width);
    }

    void horizontal() {
        const PixelBox& plot = layout_.plot;
        const LogRange range = logRangeOf(drawn(&ChartPoint::x));
        const double pad = margin(plot.width());
        layout_.x = axisOver(range, plot.left, plot.right, pad, roomForNames(range, pad));
        layout_.x.ticks = ticksOf(layout_.x, px(46.0));
        for (const ChartTick& tick : layout_.x.ticks) {
            const double x = layout_.x.pixelOf(tick.value) - fonts_.regular.width(tick.label, px(12.0)) / 2.0;
            if (!tick.label.empty()) {
                write(tick.label, {x, plot.bottom + px(20.0)}, 12.0, grey);
            }
        }
        if (!chart_.xLabel.empty()) {
            const std::string text = fonts_.regular.shorten(chart_.xLabel, px(13.0), plot.width());
            const double x = (plot.left + plot.right - fonts_.regular.width(text, px(13.0))) / 2.0;
            write(text, {x, xLabelBaseline_}, 13.0, dark);
        }
    }

    void points() {
        for (std::size_t i = 0; i < chart_.series.size(); ++i) {
            PlacedSeries placed;
            placed.color = palette[i % palette.size()];
            // After one round of the colours each is combined with another marker.
            placed.marker = static_cast<ChartMarker>((i + i / palette.size()) % markerKinds);
            const std::vector<ChartPoint>& points = chart_.series[i].points;
            for (std::size_t k = 0; k < points.size(); ++k) {
                if (isDrawable(points[k])) {
                    placed.points.push_back({k, layout_.pixelOf(points[k])});
                }
            }
            layout_.series.push_back(std::move(placed));
        }
        if (drawn(&ChartPoint::x).empty()) {
            const std::string text = "no values to show";
            const double x = (layout_.plot.left + layout_.plot.right - fonts_.regular.width(text, px(15.0))) / 2.0;
            write(text, {x, (layout_.plot.top + layout_.plot.bottom) / 2.0}, 15.0, grey);
        }
    }

    void pareto() {
        for (const ChartPoint& point : paretoFrontOf(chart_)) {
            layout_.paretoFront.push_back(layout_.pixelOf(point));
        }
        if (layout_.paretoFront.empty()) {
            return;
        }
        const std::string text = "Pareto front";
        const double x = layout_.plot.right - fonts_.regular.width(text, px(12.0));
        write(text, {x, headerBaseline_}, 12.0, grey);
        const double y = headerBaseline_ - fonts_.regular.capHeight(px(12.0)) / 2.0;
        layout_.paretoSample = {{x - px(42.0), y}, {x - px(14.0), y}};
    }

    const Chart& chart_;
    const ChartFonts& fonts_;
    double width_;
    double height_;
    double headerBaseline_ = 0.0;
    double xLabelBaseline_ = 0.0;
    ChartLayout layout_;
};

}  // namespace

bool isDrawable(const ChartPoint& point) {
    return point.x > 0.0 && point.y > 0.0 && std::isfinite(point.x) && std::isfinite(point.y);
}

std::vector<ChartPoint> paretoFrontOf(const Chart& chart) {
    std::vector<ChartPoint> points;
    for (const ChartSeries& series : chart.series) {
        std::copy_if(series.points.begin(), series.points.end(), std::back_inserter(points), isDrawable);
    }
    std::stable_sort(points.begin(), points.end(),
                     [](const ChartPoint& a, const ChartPoint& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    std::vector<ChartPoint> front;
    for (const ChartPoint& point : points) {
        if (front.empty() || point.y < front.back().y) {
            front.push_back(point);
        }
    }
    return front;
}

ChartLayout layoutChart(const Chart& chart, const ChartFonts& fonts, int width, int height, double scale) {
    requireSize(width, height, scale);
    return Builder(chart, fonts, width, height, scale).build();
}

}  // namespace timeshade
