#pragma once

#include <vector>

#include "image/image_file.h"

namespace timeshade {

/// A square of a picture, in pixels.
struct PixelSquare {
    int x = 0, y = 0, side = 0;
};

/// Where a picture differs from its reference in the most pixels by more than 30 of 255, of the squares at multiples of
/// a quarter of the side; the first of several. The side is cut down to the picture's.
PixelSquare worstSquare(const DisplayImage& picture, const DisplayImage& reference, int side);

/// The same square of all the pictures: a row for each list, with lists of equal length; every pixel `zoom` pixels
/// wide, a pixel of white between pictures.
DisplayImage detailStrip(const std::vector<std::vector<DisplayImage>>& rows, const PixelSquare& square, int zoom);

}  // namespace timeshade
