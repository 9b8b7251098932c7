#pragma once

#include "chart/chart_font.h"
#include "chart/chart_layout.h"

namespace timeshade {

struct TextStyle {
    double size = 12.0;
    Rgb color;
    bool bold = false;
};

/// One line of text with its baseline starting there.
PlacedText placeText(const ChartFonts& fonts, const std::string& text, PixelPoint baseline, const TextStyle& style);

/// Finds room inside the plot for names, labels and slopes, once its points are placed. Nothing covers a marker or
/// another text; where that leaves a choice, what stays clear of curves and close to its point wins. Names are
/// written even where there is no room, labels of points are not.
void placeLabels(const Chart& chart, const ChartFonts& fonts, ChartLayout& layout);

}  // namespace timeshade
