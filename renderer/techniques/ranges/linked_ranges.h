#pragma once

#include <optional>

#include "gl/framebuffer.h"
#include "gl/growing_buffer.h"
#include "techniques/ranges/range_lists.h"

namespace timeshade {

/// The published form (Hong and Oh 2019, section 4): a geometry shader makes prisms, with the special case of edges
/// that cross on the screen; linked lists of 16-byte fragments; a sub-pass over all texels sorts those of one triangle
/// by depth and links 24-byte ranges. Times, places and window depths are taken as linear in the map. What the paper
/// leaves open: a moving light's map travels with it, as every map here does; buffers start small and the collection is
/// drawn again when they must grow (the paper's have a fixed size); a triangle's odd fragment is dropped. Known to
/// fail: where a triangle comes twice at one depth (pairs by depth), where distance changes much during a range (window
/// depths are not linear in time), under a light that comes or goes (neither are places), where crossing edges leave
/// gaps in the surface, and at the near plane.
class LinkedRanges final : public RangeLists {
  public:
    explicit LinkedRanges(gl::ProgramCache& programs);
    void build(const TechniqueFrame& frame, const LightMotion& motion) override;
    void addInputs(gl::Inputs& inputs) const override;
    RangeCounts counts() const override;
    std::size_t bytes() const override;

  private:
    void collect(const TechniqueFrame& frame);
    void generate();

    gl::ProgramCache& programs_;
    gl::GrowingBuffer triangles_, heads_, fragmentList_, rangeHeads_, rangeList_;
    gl::Buffer counts_;
    gl::VertexArray none_;
    gl::Framebuffer target_;
    std::size_t texels_ = 0, capacity_ = 0, prisms_ = 0, fragments_ = 0;
};

}  // namespace timeshade
