#pragma once

#include <optional>

#include "gl/framebuffer.h"
#include "gl/growing_buffer.h"
#include "passes/cell_lists.h"
#include "passes/stochastic_rasterizer.h"
#include "technique/stored_along_line.h"
#include "technique/technique_frame.h"

namespace timeshade {

/// What was counted while it was built.
struct VisibilityMapCounts {
    std::size_t hits = 0;         ///< times at which a texel saw something, of all texels
    std::size_t texelsInUse = 0;  ///< texels that saw something at any time
    std::size_t mostNodes = 0;    ///< of a texel
    std::size_t nodes = 0;
};

/// For each texel of the light's map the visibility function of what its centre sees move: 1 less the share of the
/// exposure during which something was nearer than a depth, with the depths that were seen at one random time of each
/// stratum. Depths are distances along the light's axis in world units. It is stored as the nodes of
/// shared/visibility_function.shared.h, within the setting `error` of what was seen, in lists of exact size.
class VisibilityMap {
  public:
    /// Depths of more bytes than that are drawn some rows of the map at a time, at least one, and twice: to count nodes
    /// and to fill in.
    VisibilityMap(gl::ProgramCache& programs, std::size_t maximumRawBytes);

    /// The strata of the shutter, one time of each: at least 1, at most maximumTimes. The frame's uniforms, the
    /// technique's settings and the mesh must be bound. Throws LimitError where the nodes do not fit.
    void build(const TechniqueFrame& frame, const StochasticRasterizer::Strata& strata);
    /// `nodes` and `nodeOffsets` of nodes.glsl.
    void addInputs(gl::Inputs& inputs) const;
    /// What the line's texels hold, for storedAlong: of each function, the light that is lost from one depth to the
    /// next, at all times. A segment between two nodes is shown at its nearer end.
    void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const;
    VisibilityMapCounts counts() const;
    /// Of the depths at all times, for as many rows of the map as are drawn at once.
    std::size_t rawBytes() const { return samples_ ? samples_->bytes() : 0; }
    /// Of places and nodes, without what is needed to build them. Waits for the device.
    std::size_t functionBytes() const;
    std::size_t bytes() const;

    static constexpr int maximumTimes = 256;

  private:
    int rowsAtOnce(const MapSize& size, std::uint32_t times) const;
    void drawAll(const TechniqueFrame& frame, const StochasticRasterizer::Strata& strata, bool fill);
    void compress(const TechniqueFrame& frame, const StochasticRasterizer::Strata& strata, int firstRow, bool fill);

    gl::ProgramCache& programs_;
    std::size_t maximumRawBytes_;
    StochasticRasterizer rasterizer_;
    std::optional<gl::Texture> samples_;
    CellLists lists_;
    gl::GrowingBuffer nodes_;
    gl::Buffer counts_;
};

}  // namespace timeshade
