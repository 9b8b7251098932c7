#pragma once

#include <functional>
#include <string>

#include <glm/glm.hpp>

#include "chart/chart_canvas.h"

namespace timeshade {

/// The picture with a dark strip below it, as wide as it and 34 pixels high, for a scale or a legend that `draw` fills
/// in.
DisplayImage withStrip(const DisplayImage& picture, const std::function<void(ChartCanvas&, const ChartFont&)>& draw);

/// Letters of the strip's one size and colour, with their baseline starting at x, y.
void writeOnStrip(ChartCanvas& canvas, const ChartFont& font, const std::string& text, double x, double y);

/// Width of such letters in pixels.
double widthOnStrip(const ChartFont& font, const std::string& text);

/// An encoded colour in [0, 1] as a chart takes it.
Rgb eightBits(const glm::vec3& color);

}  // namespace timeshade
