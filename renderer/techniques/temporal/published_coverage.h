#pragma once

#include <optional>

#include "passes/moving_covers.h"
#include "technique/technique.h"

namespace timeshade {

/// The coverage map of Hong and Oh 2017 as published ("Extension"): nearest map, overlap pass, reset pass. R32F: the
/// number of the triangle that is taken to cover the texel all through the shutter, or -1. 12 bytes a texel with the
/// nearest map, and 4 of the depth buffer. It says so wherever both ends of the prism cover the texel's centre, which
/// does not mean that the triangle covers it in between; and whatever else lies in that texel is taken to be shadowed,
/// its neighbours on the same surface, too. Where the
/// paper leaves a choice: the pass without a depth test that writes depth is drawn with GL_ALWAYS, and the end that it
/// tests is the one whose depth stays.
class PublishedCoverage {
  public:
    explicit PublishedCoverage(gl::ProgramCache& programs);
    void draw(const MapSize& size, const MovingCovers& covers);
    const gl::Texture& map() const { return *coverage_; }
    std::size_t bytes() const;

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
    std::optional<gl::Texture> nearest_, coverage_, depth_;
};

}  // namespace timeshade
