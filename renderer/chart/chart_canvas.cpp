#include "chart/chart_canvas.h"

#include <algorithm>
#include <cmath>

#include "core/check.h"

namespace timeshade {
namespace {

double distanceToSegment(PixelPoint p, PixelPoint a, PixelPoint b) {
    const double dx = b.x - a.x;
    const double dy = b.y - a.y;
    const double square = dx * dx + dy * dy;
    const double along = square > 0.0 ? std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / square, 0.0, 1.0) : 0.0;
    return std::hypot(p.x - a.x - along * dx, p.y - a.y - along * dy);
}

/// Approximate coverage of a pixel whose centre is this far from a straight edge.
double coverageAt(double distance) { return std::clamp(0.5 - distance, 0.0, 1.0); }

PixelPoint between(PixelPoint a, PixelPoint b, double share) {
    return {a.x + (b.x - a.x) * share, a.y + (b.y - a.y) * share};
}

using Segment = std::pair<PixelPoint, PixelPoint>;

/// The pieces of a polyline that are drawn. The dash pattern continues around corners.
std::vector<Segment> piecesOf(std::span<const PixelPoint> points, double dash) {
    std::vector<Segment> pieces;
    double travelled = 0.0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double length = std::hypot(points[i + 1].x - points[i].x, points[i + 1].y - points[i].y);
        if (dash <= 0.0 || length <= 0.0) {
            pieces.emplace_back(points[i], points[i + 1]);
            continue;
        }
        const double end = travelled + length;
        for (double start = std::floor(travelled / (2.0 * dash)) * 2.0 * dash; start < end; start += 2.0 * dash) {
            const double from = std::max(start, travelled);
            const double to = std::min(start + dash, end);
            if (from < to) {
                pieces.emplace_back(between(points[i], points[i + 1], (from - travelled) / length),
                                    between(points[i], points[i + 1], (to - travelled) / length));
            }
        }
        travelled = end;
    }
    if (points.size() == 1) {
        pieces.emplace_back(points[0], points[0]);
    }
    return pieces;
}

/// Whole pixels that a box overlaps, clipped to the picture.
struct PixelRange {
    PixelRange(const PixelBox& box, int width, int height)
        : left(limited(box.left, width)),
          top(limited(box.top, height)),
          right(limited(box.right + 1.0, width)),
          bottom(limited(box.bottom + 1.0, height)) {}
    static int limited(double value, int size) {
        return static_cast<int>(std::clamp(std::floor(value), 0.0, static_cast<double>(size)));
    }
    int left;
    int top;
    int right;
    int bottom;
};

PixelPoint centreOf(int x, int y) { return {x + 0.5, y + 0.5}; }

}  // namespace

ChartCanvas::ChartCanvas(int width, int height, Rgb background) : width_(width), height_(height) {
    CHECK_GT(width, 0);
    CHECK_GT(height, 0);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    rgb_.reserve(pixels * 3);
    for (std::size_t i = 0; i < pixels; ++i) {
        rgb_.insert(rgb_.end(), {static_cast<float>(background.red), static_cast<float>(background.green),
                                 static_cast<float>(background.blue)});
    }
}

void ChartCanvas::blend(int x, int y, Rgb color, double opacity) {
    const std::size_t row = static_cast<std::size_t>(y) * static_cast<std::size_t>(width_);
    float* pixel = &rgb_[(row + static_cast<std::size_t>(x)) * 3];
    const auto share = static_cast<float>(opacity);
    pixel[0] += (static_cast<float>(color.red) - pixel[0]) * share;
    pixel[1] += (static_cast<float>(color.green) - pixel[1]) * share;
    pixel[2] += (static_cast<float>(color.blue) - pixel[2]) * share;
}

void ChartCanvas::fillShape(const PixelBox& around, Rgb color, const std::function<double(PixelPoint)>& distance) {
    const PixelRange range(around.grown(1.0), width_, height_);
    for (int y = range.top; y < range.bottom; ++y) {
        for (int x = range.left; x < range.right; ++x) {
            blend(x, y, color, coverageAt(distance(centreOf(x, y))));
        }
    }
}

void ChartCanvas::fillBox(const PixelBox& box, Rgb color) {
    const PixelRange range(box, width_, height_);
    for (int y = range.top; y < range.bottom; ++y) {
        const double rows = std::clamp(std::min(box.bottom, y + 1.0) - std::max(box.top, y + 0.0), 0.0, 1.0);
        for (int x = range.left; x < range.right; ++x) {
            const double columns = std::clamp(std::min(box.right, x + 1.0) - std::max(box.left, x + 0.0), 0.0, 1.0);
            blend(x, y, color, rows * columns);
        }
    }
}

void ChartCanvas::drawLine(std::span<const PixelPoint> points, const ChartStroke& stroke) {
    // Coverage of the whole line first, so that overlapping pieces do not add up.
    std::vector<float> covered(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    const double radius = stroke.width / 2.0;
    for (const auto& [a, b] : piecesOf(points, stroke.dash)) {
        const PixelBox box{std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.x, b.x), std::max(a.y, b.y)};
        const PixelRange range(box.grown(radius + 1.0), width_, height_);
        for (int y = range.top; y < range.bottom; ++y) {
            for (int x = range.left; x < range.right; ++x) {
                float& share = covered[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                                       static_cast<std::size_t>(x)];
                // A line thinner than a pixel is drawn paler, not thinner.
                const double strength = coverageAt(distanceToSegment(centreOf(x, y), a, b) - std::max(radius, 0.5));
                share = std::max(share, static_cast<float>(strength * std::min(stroke.width, 1.0)));
            }
        }
    }
    for (int y = 0; y < height_; ++y) {
        for (int x = 0; x < width_; ++x) {
            const float share =
                covered[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x)];
            if (share > 0.0f) {
                blend(x, y, stroke.color, static_cast<double>(share) * stroke.opacity);
            }
        }
    }
}

void ChartCanvas::fillDisc(PixelPoint centre, double radius, Rgb color) {
    const PixelBox box{centre.x, centre.y, centre.x, centre.y};
    fillShape(box.grown(radius), color,
              [&](PixelPoint p) { return std::hypot(p.x - centre.x, p.y - centre.y) - radius; });
}

void ChartCanvas::fillConvex(std::span<const PixelPoint> corners, Rgb color) {
    PixelBox box{corners[0].x, corners[0].y, corners[0].x, corners[0].y};
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const PixelPoint& a = corners[i];
        const PixelPoint& b = corners[(i + 1) % corners.size()];
        box = {std::min(box.left, a.x), std::min(box.top, a.y), std::max(box.right, a.x), std::max(box.bottom, a.y)};
        area += a.x * b.y - b.x * a.y;
    }
    const double side = area < 0.0 ? -1.0 : 1.0;
    fillShape(box, color, [&](PixelPoint p) {
        double farthest = -1e9;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const PixelPoint& a = corners[i];
            const PixelPoint& b = corners[(i + 1) % corners.size()];
            const double cross = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
            farthest = std::max(farthest, -side * cross / std::hypot(b.x - a.x, b.y - a.y));
        }
        return farthest;
    });
}

void ChartCanvas::drawMask(const CoverageMask& mask, Rgb color, double opacity) {
    for (int row = 0; row < mask.height; ++row) {
        for (int column = 0; column < mask.width; ++column) {
            const int x = mask.left + column;
            const int y = mask.top + row;
            if (x >= 0 && y >= 0 && x < width_ && y < height_) {
                const std::uint8_t covered = mask.coverage[static_cast<std::size_t>(row * mask.width + column)];
                blend(x, y, color, opacity * covered / 255.0);
            }
        }
    }
}

DisplayImage ChartCanvas::picture() const {
    DisplayImage image{width_, height_, {}};
    image.rgb.reserve(rgb_.size());
    for (const float value : rgb_) {
        image.rgb.push_back(static_cast<std::uint8_t>(std::lround(value)));
    }
    return image;
}

CoverageMask dilated(const CoverageMask& mask, double radius) {
    const int margin = static_cast<int>(std::ceil(radius));
    CoverageMask grown{mask.left - margin, mask.top - margin, mask.width + 2 * margin, mask.height + 2 * margin, {}};
    grown.coverage.resize(static_cast<std::size_t>(grown.width) * static_cast<std::size_t>(grown.height));
    for (int dy = -margin; dy <= margin; ++dy) {
        for (int dx = -margin; dx <= margin; ++dx) {
            const double strength = std::clamp(radius + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
            for (int row = 0; strength > 0.0 && row < mask.height; ++row) {
                for (int column = 0; column < mask.width; ++column) {
                    const auto value = static_cast<std::uint8_t>(
                        strength * mask.coverage[static_cast<std::size_t>(row * mask.width + column)]);
                    auto& target = grown.coverage[static_cast<std::size_t>((row + dy + margin) * grown.width + column +
                                                                           dx + margin)];
                    target = std::max(target, value);
                }
            }
        }
    }
    return grown;
}

CoverageMask turnedLeft(const CoverageMask& mask, int x, int y) {
    // A step to the right becomes one upwards, a step down becomes one to the right.
    CoverageMask turned{x + (mask.top - y), y - (mask.left + mask.width - x), mask.height, mask.width, {}};
    turned.coverage.resize(mask.coverage.size());
    for (int row = 0; row < mask.height; ++row) {
        for (int column = 0; column < mask.width; ++column) {
            turned.coverage[static_cast<std::size_t>((mask.width - 1 - column) * turned.width + row)] =
                mask.coverage[static_cast<std::size_t>(row * mask.width + column)];
        }
    }
    return turned;
}

}  // namespace timeshade
