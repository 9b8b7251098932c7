#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "technique/technique_frame.h"

namespace timeshade {

/// Triangles that move in either frame's shutter or between the two. Both of the same topology.
std::vector<std::uint32_t> dynamicCastersBetween(const MeshTexels& before, const MeshTexels& now);

/// Where in the light's map plane something has moved, and at what least distance from the light: a surface point
/// behind it may have another shadow than a frame ago, any other has not. Conservative: every moving triangle counts
/// with the rectangle around its positions of both frames, widened by a texel.
class DynamicMask {
  public:
    explicit DynamicMask(gl::ProgramCache& programs) : programs_(programs) {}
    /// `previousPositions`: the triangles as they were, as MeshTexels::positions. The technique's block must be bound.
    void draw(const TechniqueFrame& frame, const gl::Texture& previousPositions,
              std::span<const std::uint32_t> dynamicCasters);
    /// Texels along a side for a shadow map of the given size.
    static int sideFor(int longSide) { return longSide / 2; }  ///< of the map
    const gl::Texture& depth() const { return *depth_; }
    /// A buffer's view, R8UI: 1 for every triangle of the list drawn last.
    const gl::Texture& flags() const { return *flagsView_; }
    std::size_t bytes() const {
        return (depth_ ? depth_->bytes() : 0) + (list_ ? list_->bytes() : 0) + (flags_ ? flags_->bytes() : 0);
    }

  private:
    gl::ProgramCache& programs_;
    std::optional<gl::Framebuffer> target_;
    std::optional<gl::Texture> depth_, listView_, flagsView_;
    std::optional<gl::Buffer> list_, flags_;
};

}  // namespace timeshade
