#include "measure/epipolar_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "chart/chart_canvas.h"
#include "measure/picture_strip.h"
#include "measure/view_scale.h"
#include "shared/heat_color.shared.h"

namespace timeshade {

namespace {

constexpr int width = 1156, height = 560;
constexpr double panelTop = 64.0, leftPanel = 64.0, rightPanel = 576.0, scaleLeft = 1044.0, textSize = 13.0;
constexpr Rgb ink{32, 36, 42}, quiet{110, 116, 124}, ground{255, 255, 255}, nothing{236, 238, 240}, rule{32, 36, 42},
    wrong{214, 40, 40};
constexpr double infinity = std::numeric_limits<double>::infinity();

struct DepthRange {
    double low = 0.0, high = 1.0;
};

DepthRange depthRangeOf(const EpipolarView& view) {
    DepthRange range{infinity, -infinity};
    const auto add = [&](double depth) {
        if (!std::isfinite(depth)) return;
        range.low = std::min(range.low, depth);
        range.high = std::max(range.high, depth);
    };
    for (const SeenByLight& seen : view.truth) add(seen.triangle == NO_TRIANGLE ? infinity : seen.depth);
    if (!(range.low <= range.high))
        for (const StoredMark& mark : view.stored.marks) add(mark.depthFrom);
    if (!(range.low <= range.high)) return {};
    if (range.low == range.high) range.high = range.low + std::max(1e-6, 1e-3 * std::abs(range.low));
    return range;
}

/// Nearer is brighter.
Rgb colorOf(double depth, const DepthRange& range) {
    const double share = std::clamp((range.high - depth) / (range.high - range.low), 0.0, 1.0);
    return eightBits(shared::heatColor(static_cast<float>(share)));
}

double mixed(double a, double b, double share) { return a + (b - a) * share; }

Rgb mixed(Rgb a, Rgb b, double share) {
    const auto channel = [&](std::uint8_t x, std::uint8_t y) {
        return static_cast<std::uint8_t>(std::lround(mixed(x, y, share)));
    };
    return {channel(a.red, b.red), channel(a.green, b.green), channel(a.blue, b.blue)};
}

/// Calls visit(cell, depth) for the cells of the panel whose centres a mark of an interval covers.
template <class Visit>
void forEachCell(const EpipolarView& view, const StoredMark& mark, const Visit& visit) {
    const auto first = static_cast<std::uint32_t>(std::max(0.0, std::ceil(mark.xFrom * view.columns - 0.5)));
    for (std::uint32_t column = first; column < view.columns && (column + 0.5) / view.columns < mark.xTo; ++column) {
        const double offset = ((column + 0.5) / view.columns - mark.xFrom) / (mark.xTo - mark.xFrom) - 0.5;
        const double begin = mark.uFrom + offset * mark.uFromSlope, end = mark.uTo + offset * mark.uToSlope;
        const auto firstRow = static_cast<std::uint32_t>(std::max(0.0, std::ceil(begin * view.rows - 0.5)));
        for (std::uint32_t row = firstRow; row < view.rows && (row + 0.5) / view.rows < end; ++row)
            visit(std::size_t{row} * view.columns + column,
                  mixed(mark.depthFrom, mark.depthTo, ((row + 0.5) / view.rows - begin) / (end - begin)));
    }
}

std::vector<Rgb> storedCells(const EpipolarView& view, const DepthRange& range) {
    const std::size_t count = std::size_t{view.columns} * view.rows;
    std::vector<Rgb> cells(count, nothing);
    std::vector<double> nearest(count, infinity);
    std::vector<StoredMark> marks = view.stored.marks;
    // The farthest first, for those that let light through.
    std::stable_sort(marks.begin(), marks.end(), [](const StoredMark& a, const StoredMark& b) {
        return a.depthFrom + a.depthTo > b.depthFrom + b.depthTo;
    });
    for (const StoredMark& mark : marks) {
        if (mark.uFrom >= mark.uTo) continue;
        forEachCell(view, mark, [&](std::size_t cell, double depth) {
            if (depth > nearest[cell]) return;
            cells[cell] = mixed(cells[cell], colorOf(depth, range), mark.opacity);
            if (mark.opacity >= 1.0) nearest[cell] = depth;
        });
    }
    return cells;
}

std::vector<Rgb> trueCells(const EpipolarView& view, const DepthRange& range) {
    std::vector<Rgb> cells;
    cells.reserve(view.truth.size());
    const auto instanceOf = [&](std::size_t i) {
        const std::uint32_t triangle = view.truth[i].triangle;
        return triangle == NO_TRIANGLE ? NO_TRIANGLE : view.instances[triangle];
    };
    for (std::size_t i = 0; i < view.truth.size(); ++i) {
        const bool border = (i % view.columns > 0 && instanceOf(i) != instanceOf(i - 1)) ||
                            (i >= view.columns && instanceOf(i) != instanceOf(i - view.columns));
        const bool seen = view.truth[i].triangle != NO_TRIANGLE;
        cells.push_back(border ? rule : seen ? colorOf(view.truth[i].depth, range) : nothing);
    }
    return cells;
}

class EpipolarPainter {
  public:
    explicit EpipolarPainter(const EpipolarView& view) : view_(view), range_(depthRangeOf(view)) {}

    DisplayImage draw(const std::string& techniqueTitle) {
        panel(leftPanel, "Truth: what is nearest to the light", trueCells(view_, range_));
        panel(rightPanel, "Stored: " + techniqueTitle, storedCells(view_, range_));
        points();
        for (const EpipolarSample& sample : view_.samples)
            for (const double left : {leftPanel, rightPanel}) path(left, sample);
        for (const EpipolarSample& sample : view_.samples)
            for (const double left : {leftPanel, rightPanel}) disc(left, sample);
        scale();
        notes();
        return canvas_.picture();
    }

  private:
    double columns() const { return view_.columns; }
    double rows() const { return view_.rows; }
    PixelPoint at(double left, double x, double u) const {
        return {left + x * columns(), panelTop + (1.0 - u) * rows()};
    }

    void text(const std::string& words, double x, double baseline, Rgb color, bool bold = false) {
        canvas_.drawMask(fonts_.of(bold).render(words, textSize, x, baseline), color);
    }
    void centred(const std::string& words, double x, double baseline, Rgb color) {
        text(words, x - 0.5 * fonts_.regular.width(words, textSize), baseline, color);
    }

    void panel(double left, const std::string& title, const std::vector<Rgb>& cells) {
        text(fonts_.bold.shorten(title, textSize, columns()), left, panelTop - 16.0, ink, true);
        for (std::uint32_t row = 0; row < view_.rows; ++row) {
            const double top = panelTop + (view_.rows - 1 - row);
            for (std::uint32_t first = 0, next = 0; first < view_.columns; first = next) {
                const Rgb color = cells[std::size_t{row} * view_.columns + first];
                while (next < view_.columns && cells[std::size_t{row} * view_.columns + next] == color) ++next;
                canvas_.fillBox({left + first, top, left + next, top + 1.0}, color);
            }
        }
        axes(left);
    }

    void axes(double left) {
        const double bottom = panelTop + rows(), right = left + columns();
        const PixelPoint frame[] = {
            {left, panelTop}, {right, panelTop}, {right, bottom}, {left, bottom}, {left, panelTop}};
        canvas_.drawLine(frame, {1.0, ink, 1.0, 0.0});
        for (const double u : {0.0, 0.25, 0.5, 0.75, 1.0}) {
            const std::string number = fmt::format("{:g}", u);
            const PixelPoint tick[] = {at(left, 0.0, u), {left - 5.0, at(left, 0.0, u).y}};
            canvas_.drawLine(tick, {1.0, ink, 1.0, 0.0});
            text(number, left - 9.0 - fonts_.regular.width(number, textSize), tick[0].y + 4.5, quiet);
        }
        const int labelX = static_cast<int>(left) - 42, labelY = static_cast<int>(bottom) - 130;
        canvas_.drawMask(
            turnedLeft(fonts_.regular.render("u, time in the shutter", textSize, labelX, labelY), labelX, labelY),
            quiet);
        const double texels = view_.line.texels(glm::dvec2(view_.mapSize)), step = roundStep(texels / 6.0);
        for (double texel = 0.0; texel <= texels; texel += step) {
            const PixelPoint tick[] = {at(left, texel / texels, 0.0), {at(left, texel / texels, 0.0).x, bottom + 5.0}};
            canvas_.drawLine(tick, {1.0, ink, 1.0, 0.0});
            centred(fmt::format("{:.6g}", texel), tick[0].x, bottom + 19.0, quiet);
        }
        centred("x, along the line, in texels", left + 0.5 * columns(), bottom + 37.0, quiet);
    }

    /// What was stored of instants.
    void points() {
        for (const StoredMark& mark : view_.stored.marks) {
            if (mark.uFrom != mark.uTo) continue;
            const double radius = std::clamp(0.4 * (mark.xTo - mark.xFrom) * columns(), 1.8, 3.5);
            const PixelPoint centre = at(rightPanel, 0.5 * (mark.xFrom + mark.xTo), mark.uFrom);
            canvas_.fillDisc(centre, radius + 0.8, ink);
            canvas_.fillDisc(centre, radius, colorOf(mark.depthFrom, range_));
        }
    }

    /// The parts of a path inside the panel, from one time to another.
    void pieces(double left, const EpipolarSample& sample, double uFrom, double uTo, const ChartStroke& stroke) {
        std::vector<PixelPoint> piece;
        const auto finish = [&] {
            if (piece.size() > 1) canvas_.drawLine(piece, stroke);
            piece.clear();
        };
        for (const EpipolarPlace& place : sample.path) {
            if (place.u < uFrom || place.u > uTo || place.x < 0.0 || place.x > 1.0)
                finish();
            else
                piece.push_back(at(left, place.x, place.u));
        }
        finish();
    }

    void path(double left, const EpipolarSample& sample) {
        pieces(left, sample, 0.0, 1.0, {3.4, ink, 0.55, 0.0});
        pieces(left, sample, 0.0, 1.0, {1.4, ground, 1.0, 0.0});
        if (sample.uFrom < sample.uTo) pieces(left, sample, sample.uFrom, sample.uTo, {5.0, ground, 0.9, 0.0});
    }

    void disc(double left, const EpipolarSample& sample) {
        if (sample.place.x < 0.0 || sample.place.x > 1.0) return;
        const bool ofTruth = left == leftPanel;
        const double lit = !sample.tested ? 0.5 : ofTruth ? (sample.truth ? 1.0 : 0.0) : sample.lit;
        const PixelPoint centre = at(left, sample.place.x, sample.place.u);
        const bool differs = !ofTruth && sample.tested && std::abs(sample.lit - (sample.truth ? 1.0 : 0.0)) >= 0.5;
        if (differs) canvas_.fillDisc(centre, 9.0, wrong);
        canvas_.fillDisc(centre, 6.5, ground);
        canvas_.fillDisc(centre, 5.5, ink);
        canvas_.fillDisc(centre, 4.0, mixed(Rgb{0, 0, 0}, ground, lit));
    }

    void scale() {
        const double bottom = panelTop + rows();
        text("distance", scaleLeft - 4.0, panelTop - 16.0, quiet);
        for (int y = 0; y < static_cast<int>(view_.rows); ++y) {
            const double depth = mixed(range_.low, range_.high, (y + 0.5) / rows());
            canvas_.fillBox({scaleLeft, panelTop + y, scaleLeft + 18.0, panelTop + y + 1.0}, colorOf(depth, range_));
        }
        for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0})
            text(fmt::format("{:.4g}", mixed(range_.low, range_.high, share)), scaleLeft + 25.0,
                 mixed(panelTop, bottom, share) + 4.5, quiet);
    }

    void notes() {
        const double first = panelTop + rows() + 62.0;
        text(fmt::format("line ({:.4f}, {:.4f}) to ({:.4f}, {:.4f}) of a map of {} x {} texels", view_.line.from.x,
                         view_.line.from.y, view_.line.to.x, view_.line.to.y, view_.mapSize.x, view_.mapSize.y),
             leftPanel, first, quiet);
        if (!view_.samples.empty())
            text("discs: camera samples, white lit, black shadowed; curves: their receivers", leftPanel, first + 18.0,
                 quiet);
        const std::string note = view_.stored.note.empty() && view_.stored.marks.empty()
                                     ? "this technique shows nothing of what it stores"
                                     : view_.stored.note;
        const std::vector<std::string> lines = fonts_.regular.wrap(note, textSize, columns() + 60.0);
        for (std::size_t i = 0; i < lines.size() && i < 2; ++i)
            text(lines[i], rightPanel, first + 18.0 * static_cast<double>(i), quiet);
    }

    const EpipolarView& view_;
    DepthRange range_;
    ChartFonts fonts_;
    ChartCanvas canvas_{width, height, ground};
};

}  // namespace

DisplayImage drawEpipolarView(const EpipolarView& view, const std::string& techniqueTitle) {
    return EpipolarPainter(view).draw(techniqueTitle);
}

std::vector<double> nearestStored(const EpipolarView& view) {
    std::vector<double> nearest(std::size_t{view.columns} * view.rows, infinity);
    for (const StoredMark& mark : view.stored.marks)
        if (mark.uFrom < mark.uTo)
            forEachCell(view, mark,
                        [&](std::size_t cell, double depth) { nearest[cell] = std::min(nearest[cell], depth); });
    return nearest;
}

}  // namespace timeshade
