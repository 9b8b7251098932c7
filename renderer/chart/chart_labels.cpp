#include "chart/chart_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace timeshade {
namespace {

constexpr double noRoom = std::numeric_limits<double>::infinity();

/// Darkens a colour until text in it is legible on white (contrast 4.5, by the relative luminance of WCAG 2).
Rgb inkOf(Rgb color) {
    const auto linear = [](double value) { return std::pow(value / 255.0, 2.2); };
    const auto luminance = [&](Rgb c) {
        return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
    };
    const auto darker = [](std::uint8_t value) { return static_cast<std::uint8_t>(value * 15 / 16); };
    while (1.05 / (luminance(color) + 0.05) < 4.5) {
        color = {darker(color.red), darker(color.green), darker(color.blue)};
    }
    return color;
}

/// How much of a segment lies inside a box, in pixels (clipped as by Liang and Barsky, 1984).
double lengthInside(PixelPoint a, PixelPoint b, const PixelBox& box) {
    double enter = 0.0;
    double leave = 1.0;
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    for (const auto& [direction, room] : {std::pair(-dx, a.x - box.left), std::pair(dx, box.right - a.x),
                                          std::pair(-dy, a.y - box.top), std::pair(dy, box.bottom - a.y)}) {
        if (direction == 0.0) {
            if (room < 0.0) {
                return 0.0;
            }
        } else if (direction < 0.0) {
            enter = std::max(enter, room / direction);
        } else {
            leave = std::min(leave, room / direction);
        }
    }
    return enter < leave ? (leave - enter) * std::hypot(dx, dy) : 0.0;
}

/// Everything placed so far that a text must avoid.
class Obstacles {
  public:
    explicit Obstacles(const ChartLayout& layout) : bounds_(layout.plot.grown(-3.0 * layout.scale)) {
        for (const PlacedSeries& series : layout.series) {
            for (std::size_t i = 0; i < series.points.size(); ++i) {
                const PixelPoint p = series.points[i].pixel;
                boxes_.push_back(PixelBox{p.x, p.y, p.x, p.y}.grown(layout.markerRadius() + 2.0 * layout.scale));
                if (i > 0) {
                    addLine(series.points[i - 1].pixel, p);
                }
            }
        }
    }

    void add(const PixelBox& box) { boxes_.push_back(box); }
    void addLine(PixelPoint a, PixelPoint b) { lines_.emplace_back(a, b); }

    /// The length of curves that the box would cover; noRoom if it would cover a marker or text, or leave the plot.
    double cost(const PixelBox& box) const {
        const bool covers =
            std::any_of(boxes_.begin(), boxes_.end(), [&](const PixelBox& b) { return b.overlaps(box); });
        return covers || !bounds_.contains(box) ? noRoom : lineCost(box);
    }

    /// The length of texts and markers that a line would run through.
    double crossed(PixelPoint a, PixelPoint b) const {
        double length = 0.0;
        for (const PixelBox& box : boxes_) {
            length += lengthInside(a, b, box);
        }
        return length;
    }

    /// The same as cost() for a text that may be covered: covered boxes count by their area.
    double softCost(const PixelBox& box) const {
        double cost = bounds_.contains(box) ? lineCost(box) : noRoom;
        for (const PixelBox& b : boxes_) {
            cost += b.overlaps(box) ? b.width() + b.height() : 0.0;
        }
        return cost;
    }

  private:
    double lineCost(const PixelBox& box) const {
        double cost = 0.0;
        for (const auto& [a, b] : lines_) {
            cost += lengthInside(a, b, box);
        }
        return cost;
    }

    PixelBox bounds_;
    std::vector<PixelBox> boxes_;
    std::vector<std::pair<PixelPoint, PixelPoint>> lines_;
};

void moveBy(PlacedText& text, double dx, double dy) {
    text.baseline.x += dx;
    text.baseline.y += dy;
    text.box = {text.box.left + dx, text.box.top + dy, text.box.right + dx, text.box.bottom + dy};
}

/// Moves the text so that its box, seen from `point`, lies towards (towardsX, towardsY), each -1, 0 or 1, with a gap.
void putBeside(PlacedText& text, PixelPoint point, double towardsX, double towardsY, double gap) {
    const double x = point.x + towardsX * (gap + text.box.width() / 2.0);
    const double y = point.y + towardsY * (gap + text.box.height() / 2.0);
    moveBy(text, x - (text.box.left + text.box.right) / 2.0, y - (text.box.top + text.box.bottom) / 2.0);
}

/// Where a leader from the curve's end meets its name.
PixelPoint leaderEnd(const PlacedText& name, PixelPoint end) {
    return {name.box.left > end.x ? name.box.left : name.box.right, (name.box.top + name.box.bottom) / 2.0};
}

/// The nearest place for a name: right of the curve's end or, if there is no room, further up, down or to a side.
void placeName(const PlacedText& name, PixelPoint end, double scale, Obstacles& obstacles, PlacedSeries& series) {
    const double gap = 10.0 * scale;
    PlacedText best = name;
    putBeside(best, end, 1.0, 0.0, gap);
    double bestCost = noRoom;
    for (int row = -24; row <= 24; ++row) {
        for (int column = -12; column <= 6; ++column) {
            PlacedText candidate = name;
            const double side = column < 0 ? -1.0 : 1.0;
            putBeside(candidate, end, side, 0.0, gap);
            const double dx = side < 0.0 ? (column + 1) * 14.0 * scale : column * 14.0 * scale;
            const double dy = row * 8.0 * scale;
            moveBy(candidate, dx, dy);
            const double away = 1.5 * std::abs(dx) + std::abs(dy) + (side < 0.0 ? 40.0 * scale : 0.0);
            const double cost =
                away + 3.0 * obstacles.cost(candidate.box) + 3.0 * obstacles.crossed(end, leaderEnd(candidate, end));
            if (cost < bestCost) {
                best = candidate;
                bestCost = cost;
            }
        }
    }
    const PixelPoint edge = leaderEnd(best, end);
    if (std::hypot(edge.x - end.x, edge.y - end.y) > 18.0 * scale) {
        series.leader = {end, edge};
        obstacles.addLine(end, edge);
    }
    obstacles.add(best.box);
    series.name = std::move(best);
}

void placeNames(const Chart& chart, const ChartFonts& fonts, ChartLayout& layout, Obstacles& obstacles) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < layout.series.size(); ++i) {
        if (!layout.series[i].points.empty()) {
            order.push_back(i);
        }
    }
    // From top to bottom, so that names that have to move keep the order of their curves.
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return layout.series[a].points.back().pixel.y < layout.series[b].points.back().pixel.y;
    });
    for (const std::size_t i : order) {
        PlacedSeries& series = layout.series[i];
        const TextStyle style{13.0 * layout.scale, inkOf(series.color), true};
        const std::string text = fonts.bold.shorten(chart.series[i].name, style.size, layout.plot.width() * 0.4);
        if (!text.empty()) {
            placeName(placeText(fonts, text, {}, style), series.points.back().pixel, layout.scale, obstacles, series);
        }
    }
}

void placePointLabels(const Chart& chart, const ChartFonts& fonts, ChartLayout& layout, Obstacles& obstacles) {
    // Above first: curves fall to the right, so the space above right of a marker is mostly free.
    constexpr std::array<std::array<double, 2>, 8> sides = {
        {{0.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}, {-1.0, 1.0}, {1.0, 0.0}, {-1.0, 0.0}, {1.0, 1.0}, {-1.0, -1.0}}};
    for (std::size_t i = 0; i < layout.series.size(); ++i) {
        PlacedSeries& series = layout.series[i];
        const TextStyle style{10.5 * layout.scale, inkOf(series.color), false};
        for (const PlacedPoint& point : series.points) {
            const std::string& whole = chart.series[i].points[point.index].label;
            const std::string label = fonts.regular.shorten(whole, style.size, 0.2 * layout.plot.width());
            std::optional<PlacedText> best;
            double bestCost = noRoom;
            for (std::size_t side = 0; side < sides.size() && !label.empty(); ++side) {
                PlacedText candidate = placeText(fonts, label, {}, style);
                const bool corner = sides[side][0] != 0.0 && sides[side][1] != 0.0;
                putBeside(candidate, point.pixel, sides[side][0], sides[side][1],
                          layout.markerRadius() + (corner ? -1.0 : 3.0) * layout.scale);
                const double cost = 2.0 * obstacles.cost(candidate.box) + static_cast<double>(side) * layout.scale;
                if (cost < bestCost) {
                    best = candidate;
                    bestCost = cost;
                }
            }
            if (best) {
                obstacles.add(best->box);
                series.labels.push_back(*best);
            }
        }
    }
}

/// The slopes from a common start at the origin.
std::vector<PlacedSlope> fanOf(const Chart& chart, const ChartFonts& fonts, const ChartLayout& layout) {
    const double length = 0.2 * std::min(layout.plot.width(), layout.plot.height());
    std::vector<PlacedSlope> fan;
    for (const ChartSlope& slope : chart.slopes) {
        const double dx = layout.x.pixelsPerDecade();
        const double dy = -slope.slope * layout.y.pixelsPerDecade();
        const double share = length / std::hypot(dx, dy);
        const PixelPoint to{dx * share, dy * share};
        const TextStyle style{11.5 * layout.scale, {110, 116, 126}, false};
        PlacedText label =
            placeText(fonts, fonts.regular.shorten(slope.label, style.size, 0.4 * layout.plot.width()), {}, style);
        putBeside(label, to, 1.0, 0.0, 5.0 * layout.scale);
        fan.push_back({{}, to, label});
    }
    // Steeper lines end lower; where their labels would overlap, the lower one is moved down.
    std::stable_sort(fan.begin(), fan.end(),
                     [](const PlacedSlope& a, const PlacedSlope& b) { return a.to.y < b.to.y; });
    for (std::size_t i = 1; i < fan.size(); ++i) {
        const double missing = fan[i - 1].label.box.bottom + layout.scale - fan[i].label.box.top;
        if (missing > 0.0) {
            moveBy(fan[i].label, 0.0, missing);
        }
    }
    return fan;
}

void placeSlopes(const Chart& chart, const ChartFonts& fonts, ChartLayout& layout, const Obstacles& obstacles) {
    std::vector<PlacedSlope> fan = fanOf(chart, fonts, layout);
    if (fan.empty()) {
        return;
    }
    PixelBox around;
    for (const PlacedSlope& slope : fan) {
        around = {std::min({around.left, slope.to.x, slope.label.box.left}),
                  std::min({around.top, slope.to.y, slope.label.box.top}),
                  std::max({around.right, slope.to.x, slope.label.box.right}),
                  std::max({around.bottom, slope.to.y, slope.label.box.bottom})};
    }
    around = around.grown(8.0 * layout.scale);
    // The emptiest place on a grid over the plot; among equal ones the lowest, then the leftmost.
    constexpr int steps = 48;
    PixelPoint best{layout.plot.left - around.left, layout.plot.bottom - around.bottom};
    double bestCost = noRoom;
    for (int row = steps; row >= 0; --row) {
        for (int column = 0; column <= steps; ++column) {
            const PixelPoint origin{layout.plot.left + layout.plot.width() * column / steps,
                                    layout.plot.top + layout.plot.height() * row / steps};
            const double cost = obstacles.softCost(
                {around.left + origin.x, around.top + origin.y, around.right + origin.x, around.bottom + origin.y});
            if (cost < bestCost) {
                best = origin;
                bestCost = cost;
            }
        }
    }
    for (PlacedSlope& slope : fan) {
        slope.from = best;
        slope.to = {slope.to.x + best.x, slope.to.y + best.y};
        moveBy(slope.label, best.x, best.y);
    }
    layout.slopes = std::move(fan);
}

}  // namespace

PlacedText placeText(const ChartFonts& fonts, const std::string& text, PixelPoint baseline, const TextStyle& style) {
    const ChartFont& font = fonts.of(style.bold);
    const double height = font.capHeight(style.size);
    // Letters with tails reach below the baseline by about a quarter of the size.
    const PixelBox box{baseline.x, baseline.y - height - 0.1 * style.size, baseline.x + font.width(text, style.size),
                       baseline.y + 0.24 * style.size};
    return {text, baseline, box, style.size, style.color, style.bold, false};
}

void placeLabels(const Chart& chart, const ChartFonts& fonts, ChartLayout& layout) {
    Obstacles obstacles(layout);
    placeNames(chart, fonts, layout, obstacles);
    placePointLabels(chart, fonts, layout, obstacles);
    placeSlopes(chart, fonts, layout, obstacles);
}

}  // namespace timeshade
