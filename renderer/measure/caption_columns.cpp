#include "measure/caption_columns.h"

#include <algorithm>
#include <cmath>

#include "chart/chart_canvas.h"

namespace timeshade {

namespace {

constexpr int leastColumn = 256;  // pixels, for words to have room
constexpr int gap = 6;            // between columns, and between a picture and its detail
constexpr Rgb ground{20, 20, 24}, titleColor{250, 250, 250}, lineColor{215, 215, 222};

/// Where things lie; the same in every column.
struct Layout {
    Layout(const DisplayImage& picture, const PixelSquare& square)
        : scale(std::max(1, (leastColumn + picture.width - 1) / picture.width)),
          column(picture.width * scale),
          pictureHeight(picture.height * scale),
          zoom(std::max(1, column / square.side)),
          detail(square.side * zoom) {}

    double letters() const { return std::clamp(column / 22.0, 12.0, 22.0); }
    int captionTop() const { return pictureHeight + gap + detail; }

    int scale, column, pictureHeight, zoom, detail;
};

/// A line of a caption, broken to fit.
struct Line {
    std::string text;
    bool bold;
};

std::vector<Line> linesOf(const CaptionedPicture& captioned, const ChartFonts& fonts, const Layout& layout) {
    const double room = layout.column - layout.letters();
    std::vector<Line> lines;
    const auto add = [&](const std::string& text, bool bold) {
        const ChartFont& font = fonts.of(bold);
        for (const std::string& line : font.wrap(text, layout.letters(), room))
            lines.push_back({font.shorten(line, layout.letters(), room), bold});
    };
    add(captioned.title, true);
    for (const std::string& line : captioned.lines) add(line, false);
    return lines;
}

std::uint8_t* pixelOf(DisplayImage& image, int x, int y) {
    return &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x))];
}

const std::uint8_t* pixelOf(const DisplayImage& image, int x, int y) {
    return &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x))];
}

/// Copies a rectangle of a picture, every pixel `factor` pixels wide, to left, top.
void enlarge(const DisplayImage& from, PixelSquare corner, int width, int height, int factor, DisplayImage& to,
             int left, int top) {
    for (int y = 0; y < height * factor; ++y)
        for (int x = 0; x < width * factor; ++x)
            std::copy_n(pixelOf(from, corner.x + x / factor, corner.y + y / factor), 3, pixelOf(to, left + x, top + y));
}

/// A light line around the square, just outside of it, with a dark one around that: seen on anything.
void outline(DisplayImage& to, const PixelSquare& square, const Layout& layout, int left) {
    const int x0 = square.x * layout.scale, y0 = square.y * layout.scale, side = square.side * layout.scale;
    for (int ring = 1; ring <= 2; ++ring) {
        const std::uint8_t level = ring == 1 ? 250 : 30;
        const auto mark = [&](int x, int y) {
            if (x >= 0 && y >= 0 && x < layout.column && y < layout.pictureHeight)
                std::fill_n(pixelOf(to, left + x, y), 3, level);
        };
        for (int i = -ring; i < side + ring; ++i) {
            mark(x0 + i, y0 - ring);
            mark(x0 + i, y0 + side + ring - 1);
            mark(x0 - ring, y0 + i);
            mark(x0 + side + ring - 1, y0 + i);
        }
    }
}

/// All captions as one strip.
DisplayImage captions(const std::vector<CaptionedPicture>& columns, const Layout& layout, int width) {
    const ChartFonts fonts;
    std::vector<std::vector<Line>> lines;
    std::size_t most = 0;
    for (const CaptionedPicture& column : columns) {
        lines.push_back(linesOf(column, fonts, layout));
        most = std::max(most, lines.back().size());
    }
    const double size = layout.letters(), pitch = 1.4 * size;
    ChartCanvas canvas(width, static_cast<int>(std::lround(pitch * static_cast<double>(most) + size)), ground);
    for (std::size_t c = 0; c < lines.size(); ++c)
        for (std::size_t i = 0; i < lines[c].size(); ++i) {
            const double x = static_cast<double>(c) * (layout.column + gap) + 0.5 * size;
            const double y = 0.3 * size + pitch * (static_cast<double>(i) + 0.8);
            const Line& line = lines[c][i];
            canvas.drawMask(fonts.of(line.bold).render(line.text, size, x, y), line.bold ? titleColor : lineColor);
        }
    return canvas.picture();
}

}  // namespace

DisplayImage captionColumns(const std::vector<CaptionedPicture>& columns, const PixelSquare& square) {
    const DisplayImage& first = columns.front().picture;
    const Layout layout(first, square);
    const int count = static_cast<int>(columns.size());
    const int width = count * (layout.column + gap) - gap;
    const DisplayImage words = captions(columns, layout, width);
    DisplayImage whole = ChartCanvas(width, layout.captionTop(), ground).picture();
    for (int c = 0; c < count; ++c) {
        const DisplayImage& picture = columns[static_cast<std::size_t>(c)].picture;
        const int left = c * (layout.column + gap);
        enlarge(picture, {0, 0, 0}, first.width, first.height, layout.scale, whole, left, 0);
        outline(whole, square, layout, left);
        enlarge(picture, square, square.side, square.side, layout.zoom, whole, left, layout.pictureHeight + gap);
    }
    whole.rgb.insert(whole.rgb.end(), words.rgb.begin(), words.rgb.end());
    whole.height += words.height;
    return whole;
}

}  // namespace timeshade
