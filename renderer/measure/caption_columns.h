#pragma once

#include <string>
#include <vector>

#include "image/image_file.h"
#include "measure/detail_strip.h"

namespace timeshade {

/// A picture with what is said of it.
struct CaptionedPicture {
    DisplayImage picture;
    std::string title;
    std::vector<std::string> lines;
};

/// Pictures of equal size side by side, each a column: the whole picture with the square outlined, the square
/// magnified to the column's width, title and lines. Pixels are enlarged by whole factors, and small pictures so that
/// words have room; words that still have none are broken into several lines, or cut off.
DisplayImage captionColumns(const std::vector<CaptionedPicture>& columns, const PixelSquare& square);

}  // namespace timeshade
