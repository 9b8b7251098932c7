#include "measure/detail_strip.h"

#include <algorithm>
#include <cstdlib>

#include "measure/metrics.h"

namespace timeshade {

namespace {

const std::uint8_t* pixelOf(const DisplayImage& image, int x, int y) {
    return &image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(x))];
}

bool isWrong(const std::uint8_t* a, const std::uint8_t* b) {
    for (int channel = 0; channel < 3; ++channel)
        if (std::abs(a[channel] - b[channel]) > visibleLevels) return true;
    return false;
}

}  // namespace

PixelSquare worstSquare(const DisplayImage& picture, const DisplayImage& reference, int side) {
    side = std::min({side, picture.width, picture.height});
    const int step = std::max(1, side / 4);
    PixelSquare worst{0, 0, side};
    int most = -1;
    for (int top = 0; top + side <= picture.height; top += step)
        for (int left = 0; left + side <= picture.width; left += step) {
            int wrong = 0;
            for (int y = top; y < top + side; ++y)
                for (int x = left; x < left + side; ++x)
                    wrong += isWrong(pixelOf(picture, x, y), pixelOf(reference, x, y)) ? 1 : 0;
            if (wrong <= most) continue;
            most = wrong;
            worst.x = left;
            worst.y = top;
        }
    return worst;
}

DisplayImage detailStrip(const std::vector<std::vector<DisplayImage>>& rows, const PixelSquare& square, int zoom) {
    const int pitch = square.side * zoom + 1, columns = static_cast<int>(rows.front().size());
    DisplayImage out;
    out.width = pitch * columns - 1;
    out.height = pitch * static_cast<int>(rows.size()) - 1;
    out.rgb.assign(3 * static_cast<std::size_t>(out.width) * static_cast<std::size_t>(out.height), 255);
    for (int y = 0; y < out.height; ++y)
        for (int x = 0; x < out.width; ++x) {
            if (x % pitch == pitch - 1 || y % pitch == pitch - 1) continue;
            const DisplayImage& picture =
                rows[static_cast<std::size_t>(y / pitch)][static_cast<std::size_t>(x / pitch)];
            const std::uint8_t* from = pixelOf(picture, square.x + x % pitch / zoom, square.y + y % pitch / zoom);
            std::copy_n(from, 3,
                        &out.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(out.width) +
                                      static_cast<std::size_t>(x))]);
        }
    return out;
}

}  // namespace timeshade
