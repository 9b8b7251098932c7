#pragma once

#include <optional>
#include <vector>

#include "chart/chart.h"
#include "chart/chart_geometry.h"
#include "gl/texture.h"
#include "window/accuracy_probe.h"

namespace timeshade {

/// Error against milliseconds, one curve per technique and settings, joined in the order of their sample counts.
Chart trailChart(const std::vector<ProbePoint>& trail, bool softwareRenderer);

/// The chart as a texture, drawn anew only when it changes.
class TrailChart {
  public:
    /// `revision` changes with the trail and with `current`, which is null or points into it. Throws Error as
    /// drawChart.
    void update(const std::vector<ProbePoint>& trail, const ProbePoint* current, int revision, int width, int height,
                double scale, bool softwareRenderer);

    const gl::Texture* picture() const { return texture_ ? &*texture_ : nullptr; }
    /// Where the current point lies, in the chart's pixels from its upper left corner.
    std::optional<PixelPoint> currentPlace() const { return current_; }

  private:
    std::optional<gl::Texture> texture_;
    std::optional<PixelPoint> current_;
    int revision_ = -1;
    double scale_ = 0.0;
};

}  // namespace timeshade
