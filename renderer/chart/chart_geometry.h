#pragma once

#include <cstdint>

namespace timeshade {

/// Pixels from the left and from the top; the pixel (i, j) covers [i, i + 1) x [j, j + 1).
struct PixelPoint {
    double x = 0.0;
    double y = 0.0;
};

struct PixelBox {
    double left = 0.0;
    double top = 0.0;
    double right = 0.0;
    double bottom = 0.0;

    double width() const { return right - left; }
    double height() const { return bottom - top; }
    bool overlaps(const PixelBox& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
    bool contains(const PixelBox& other) const {
        return left <= other.left && other.right <= right && top <= other.top && other.bottom <= bottom;
    }
    PixelBox grown(double by) const { return {left - by, top - by, right + by, bottom + by}; }
};

/// sRGB encoded.
struct Rgb {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;

    bool operator==(const Rgb&) const = default;
};

}  // namespace timeshade
