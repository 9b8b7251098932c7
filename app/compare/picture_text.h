#pragma once

#include <string>

#include "chart/chart_font.h"
#include "image/image_file.h"

namespace timeshade {

/// Words drawn into a picture, on darkened ground, in letters that suit its height.
class PictureText {
  public:
    enum class Side { Left, Right };

    /// A line in an upper corner of the columns [left, right); there, only what stands before its comma, or nothing,
    /// where it has no room.
    void drawLabel(DisplayImage& picture, const std::string& text, int left, int right, Side side) const;
    /// A bold title and a text of several lines along the lower edge.
    void drawCaption(DisplayImage& picture, const std::string& title, const std::string& text) const;

  private:
    ChartFonts fonts_;
};

}  // namespace timeshade
