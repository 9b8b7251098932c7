#pragma once

#include <memory>
#include <optional>

#include "gl/foreseen_count.h"
#include "gl/framebuffer.h"
#include "gl/growing_buffer.h"
#include "techniques/ranges/range_lists.h"

namespace timeshade {

/// The published form (Hong and Oh 2019, section 4): a geometry shader makes prisms of six vertices in view space, with
/// the special case of edges that cross on the screen; linked lists of 16-byte fragments; a pass over all texels sorts
/// the fragments of a triangle by depth and links 24-byte ranges. Times are interpolated with perspective, depths are
/// as rasterised, and linear in time along a range. Still triangles have prisms, too: two caps that coincide, a range
/// of the whole shutter. Our choices where the paper is silent: the map travels with a moving light; buffers start
/// small and the collection is drawn again if they must grow (the paper's have a fixed size); an unpaired fragment of a
/// triangle is dropped, as are those beyond four. Known failures: neighbours on one surface shadow each other (numbers
/// keep a triangle from shadowing itself alone); a triangle that covers a texel twice at one depth (pairs by depth);
/// distance that changes much during a range (NDC depth is not linear in time); gaps at crossing edges; the near plane.
class LinkedRanges final : public RangeLists {
  public:
    explicit LinkedRanges(gl::ProgramCache& programs);
    void build(const TechniqueFrame& frame, const LightMotion& motion) override;
    void addInputs(gl::Inputs& inputs) const override;
    void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const override;
    RangeCounts counts() const override;
    std::size_t bytes() const override;

  private:
    void collect(const TechniqueFrame& frame, std::size_t room);
    void generate();

    gl::ProgramCache& programs_;
    gl::GrowingBuffer triangles_, heads_, fragmentList_, rangeHeads_, rangeList_;
    gl::Buffer counts_;
    gl::VertexArray none_;
    gl::Framebuffer target_;
    std::size_t texels_ = 0, prisms_ = 0, fragments_ = 0;  ///< at most
    std::shared_ptr<gl::ForeseenCount> foreseen_ = std::make_shared<gl::ForeseenCount>();
};

}  // namespace timeshade
