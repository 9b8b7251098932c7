#include "compare/picture_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace timeshade {

namespace {

constexpr double backgroundOpacity = 0.68;
constexpr double leastLabel = 8.0;  // letter sizes of room in which a longer name is shortened

double letterSize(const DisplayImage& picture) { return std::max(11.0, picture.height / 24.0); }

void blend(DisplayImage& picture, int x, int y, double level, double opacity) {
    if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) return;
    std::uint8_t* pixel =
        picture.rgb.data() +
        3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x));
    for (int c = 0; c < 3; ++c)
        pixel[c] = static_cast<std::uint8_t>(std::lround(pixel[c] + opacity * (level - pixel[c])));
}

void darken(DisplayImage& picture, int left, int top, int right, int bottom) {
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < right; ++x) blend(picture, x, y, 12.0, backgroundOpacity);
}

void write(DisplayImage& picture, const CoverageMask& mask, double level) {
    for (int y = 0; y < mask.height; ++y)
        for (int x = 0; x < mask.width; ++x)
            blend(picture, mask.left + x, mask.top + y, level,
                  mask.coverage[static_cast<std::size_t>(y * mask.width + x)] / 255.0);
}

}  // namespace

void PictureText::drawLabel(DisplayImage& picture, const std::string& text, int left, int right, Side side) const {
    const double size = letterSize(picture), margin = 0.5 * size;
    const double room = right - left - 4.0 * margin;
    // Where a seam leaves less room, the name alone, or nothing: half a word that changes from frame to frame says
    // less.
    std::string shown = text;
    if (fonts_.bold.width(shown, size) > room) shown = text.substr(0, text.find(','));
    if (room > leastLabel * size) shown = fonts_.bold.shorten(shown, size, room);
    if (shown.empty() || fonts_.bold.width(shown, size) > room) return;
    const double width = fonts_.bold.width(shown, size);
    const double x = side == Side::Left ? left + 2.0 * margin : right - 2.0 * margin - width;
    const auto pixel = [](double value) { return static_cast<int>(std::lround(value)); };
    darken(picture, pixel(x - margin), pixel(margin), pixel(x + width + margin), pixel(margin + 1.7 * size));
    write(picture, fonts_.bold.render(shown, size, x, margin + 0.85 * size + 0.5 * fonts_.bold.capHeight(size)), 245.0);
}

void PictureText::drawCaption(DisplayImage& picture, const std::string& title, const std::string& text) const {
    if (title.empty() && text.empty()) return;
    const double size = letterSize(picture), margin = size, line = 1.35 * size;
    const std::vector<std::string> lines =
        text.empty() ? std::vector<std::string>{} : fonts_.regular.wrap(text, size, picture.width - 2.0 * margin);
    const double titleHeight = title.empty() ? 0.0 : 1.45 * size;
    const double top = picture.height - titleHeight - line * static_cast<double>(lines.size()) - 0.9 * size;
    darken(picture, 0, static_cast<int>(std::lround(top)), picture.width, picture.height);
    double y = top + 0.45 * size;
    if (!title.empty()) {
        write(picture,
              fonts_.bold.render(fonts_.bold.shorten(title, 1.1 * size, picture.width - 2.0 * margin), 1.1 * size,
                                 margin, y + size),
              250.0);
        y += titleHeight;
    }
    for (const std::string& words : lines) {
        write(picture, fonts_.regular.render(words, size, margin, y + 0.95 * size), 225.0);
        y += line;
    }
}

}  // namespace timeshade
