#pragma once

#include <optional>
#include <vector>

#include "frame/lookup_pass.h"
#include "passes/interval_samples.h"

namespace timeshade {

/// Draws a lookup program over the parts of interval samples: one value a part. A technique that solves intervals is
/// asked for the mean over the part, on the position's ray; any other for its own footprint at a random time of the
/// part, which lies in one stratum.
class PartLookup {
  public:
    explicit PartLookup(gl::ProgramCache& programs) : programs_(programs), target_("part visibility target") {}
    void draw(const TechniqueFrame& frame, const Lookup& lookup, const IntervalSamples& samples, bool solvesIntervals);

    /// RGBA32F, part i in column i % SEEN_PARTS_IN_ROW and row i / SEEN_PARTS_IN_ROW. x: lit, over the times at which
    /// the receiver is tested; y: their share of the part. Where intervals are solved, of the times at which it is lit,
    /// from 0 to 1 over the part, z: the mean, w: the mean of the squares.
    const gl::Texture& values() const { return *values_; }
    std::size_t bytes() const { return values_ ? values_->bytes() : 0; }

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
    std::optional<gl::Texture> values_;
};

}  // namespace timeshade
