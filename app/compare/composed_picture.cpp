#include "compare/composed_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace timeshade {

namespace {

/// Copies columns [from, from + count) of a picture to those that begin at `to`.
template <typename Image>
void copyColumns(const Image& source, int from, int count, Image& target, int to) {
    for (int y = 0; y < source.height; ++y) {
        const auto row = static_cast<std::ptrdiff_t>(y) * source.width * 3;
        std::copy_n(source.rgb.begin() + row + 3 * from, 3 * count, target.rgb.begin() + row + 3 * to);
    }
}

/// A light line with dark edges, seen on anything.
void drawSeam(DisplayImage& picture, int column) {
    for (int x = column - 1; x <= column + 1; ++x) {
        if (x < 0 || x >= picture.width) continue;
        const std::uint8_t level = x == column ? 245 : 30;
        for (int y = 0; y < picture.height; ++y)
            std::fill_n(picture.rgb.begin() + 3 * (static_cast<std::ptrdiff_t>(y) * picture.width + x), 3, level);
    }
}

DisplayImage difference(const DisplayImage& first, const DisplayImage& second, int gain) {
    DisplayImage result = first;
    for (std::size_t i = 0; i < result.rgb.size(); ++i)
        result.rgb[i] =
            static_cast<std::uint8_t>(std::min(255, gain * std::abs(int(first.rgb[i]) - int(second.rgb[i]))));
    return result;
}

/// Parts of both beside each other, without a line between them.
template <typename Image>
Image joined(const Image& first, const Image& second, CompareMode mode, double seam) {
    assert(first.width == second.width && first.height == second.height);
    Image result = first;
    const int width = first.width;
    if (mode == CompareMode::Wipe) {
        const int column = seamColumn(width, seam);
        copyColumns(second, column, width - column, result, column);
        return result;
    }
    const int left = width / 2, right = width - left;
    copyColumns(first, (width - left) / 2, left, result, 0);
    copyColumns(second, (width - right) / 2, right, result, left);
    return result;
}

}  // namespace

int seamColumn(int width, double seam) { return static_cast<int>(std::lround(std::clamp(seam, 0.0, 1.0) * width)); }

std::string differenceLabel(int gain, const std::string& first, const std::string& second) {
    return fmt::format("{} x |{} - {}|", gain, first, second);
}

DisplayImage composed(const DisplayImage& first, const DisplayImage& second, CompareMode mode, double seam, int gain) {
    if (mode == CompareMode::Difference) return difference(first, second, gain);
    DisplayImage picture = joined(first, second, mode, seam);
    const int column = mode == CompareMode::Side ? picture.width / 2 : seamColumn(picture.width, seam);
    if (column > 0 && column < picture.width) drawSeam(picture, column);
    return picture;
}

LinearImage composed(const LinearImage& first, const LinearImage& second, CompareMode mode, double seam) {
    if (mode != CompareMode::Difference) return joined(first, second, mode, seam);
    LinearImage result = first;
    for (std::size_t i = 0; i < result.rgb.size(); ++i) result.rgb[i] = std::abs(first.rgb[i] - second.rgb[i]);
    return result;
}

}  // namespace timeshade
