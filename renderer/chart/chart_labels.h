#pragma once

#include "chart/chart_font.h"
#include "chart/chart_layout.h"

namespace timeshade {

struct TextStyle {
    double size = 12.0;
    Rgb color;
    bool bold = false;
};

/// One line of text whose baseline starts at `baseline`.
PlacedText placeText(const ChartFonts& fonts, const std::string& text, PixelPoint baseline, const TextStyle& style);

/// Places names, labels and slopes inside the plot once its points are placed. No text covers a marker or another text.
/// Among the free places, one that is close to its point and clear of curves is preferred. Names are always drawn,
/// labels of points only where there is room.
void placeLabels(const Chart& chart, const ChartFonts& fonts, ChartLayout& layout);

}  // namespace timeshade
