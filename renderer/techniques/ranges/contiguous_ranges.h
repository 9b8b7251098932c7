#pragma once

#include <optional>

#include "gl/framebuffer.h"
#include "gl/growing_buffer.h"
#include "passes/cell_lists.h"
#include "techniques/ranges/range_lists.h"

namespace timeshade {

/// The repaired form. Each texel's fragments lie in a row in arrays of their fields (count, scan, fill), so that every
/// array may fill a storage block of its own, and are sorted into ranges where they lie: 20 bytes a fragment (triangle,
/// time, distance, and how the two change from texel to texel), 40 a range, nothing twice. A list has room for an even
/// number, so that the two ends of a range are one texel of each buffer texture.
class ContiguousRanges final : public RangeLists {
  public:
    explicit ContiguousRanges(gl::ProgramCache& programs);
    void build(const TechniqueFrame& frame, const LightMotion& motion) override;
    void addInputs(gl::Inputs& inputs) const override;
    void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const override;
    RangeCounts counts() const override;
    std::size_t bytes() const override;

  private:
    std::size_t makeRoom(std::size_t places);
    void drawPrisms(const TechniqueFrame& frame, bool fill);

    gl::ProgramCache& programs_;
    CellLists lists_;
    gl::GrowingBuffer triangles_, ids_, times_, distances_, slopes_;
    gl::Buffer counts_, indices_;
    gl::VertexArray none_;
    gl::Framebuffer target_;
    std::size_t prisms_ = 0, places_ = 0;  ///< of these at most
};

}  // namespace timeshade
