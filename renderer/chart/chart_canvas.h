#pragma once

#include "chart/chart_font.h"
#include "chart/chart_geometry.h"
#include "image/image_file.h"

#include <functional>
#include <span>
#include <vector>

namespace timeshade {

struct ChartStroke {
    double width = 1.0;  ///< pixels
    Rgb color;
    double opacity = 1.0;
    double dash = 0.0;  ///< pixels drawn, then the same length of gap; 0: no dashes
};

/// Anti-aliased shapes on a picture. Colours are blended in sRGB encoding, so that thin dark lines and letters on a
/// light background look even.
class ChartCanvas {
  public:
    ChartCanvas(int width, int height, Rgb background);

    void fillBox(const PixelBox& box, Rgb color);
    /// Round ends and joins. Where the line crosses itself, its opacity is applied once.
    void drawLine(std::span<const PixelPoint> points, const ChartStroke& stroke);
    void fillDisc(PixelPoint centre, double radius, Rgb color);
    /// Corners in either order around.
    void fillConvex(std::span<const PixelPoint> corners, Rgb color);
    void drawMask(const CoverageMask& mask, Rgb color, double opacity = 1.0);

    DisplayImage picture() const;

  private:
    /// Blends the color where `distance` (pixels, negative inside) says that a shape is.
    void fillShape(const PixelBox& around, Rgb color, const std::function<double(PixelPoint)>& distance);
    void blend(int x, int y, Rgb color, double opacity);

    int width_;
    int height_;
    std::vector<float> rgb_;  ///< 0 to 255
};

/// Grows a mask by `radius` pixels on all sides.
CoverageMask dilated(const CoverageMask& mask, double radius);

/// The same mask turned 90 degrees to the left around the point x, y.
CoverageMask turnedLeft(const CoverageMask& mask, int x, int y);

}  // namespace timeshade
