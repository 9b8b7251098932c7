#pragma once

#include <memory>
#include <optional>

#include "gl/foreseen_count.h"
#include "gl/growing_buffer.h"
#include "passes/moving_covers.h"
#include "techniques/temporal/published_coverage.h"
#include "techniques/temporal/tuple_lists.h"

namespace timeshade {

/// The published form (Hong and Oh 2017), with its errors: the volume that a triangle sweeps is a prism of flat
/// triangles, also where the triangle stands still; per texel its first and last fragment in time make one tuple,
/// whatever is between; times are interpolated with perspective, depths are as rasterised; linked lists of tuples, 20
/// bytes and 4 for the next; ids of the coverage map are floats. It is wrong where neighbours on one surface shadow
/// each other, since numbers keep a triangle from shadowing itself alone; for triangles that rotate (curved sides),
/// that cover a texel twice, whose distance changes much within a tuple of a spot light; and at the light's near plane.
/// The first and last fragment need no sorting here: one fragment per triangle and texel finds all those of the prism.
class PublishedTuples final : public TupleLists {
  public:
    explicit PublishedTuples(gl::ProgramCache& programs);

    void build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& moving, bool coverageMap) override;
    void addInputs(gl::Inputs& inputs) const override;
    void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const override;
    TupleCounts counts() const override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

  private:
    gl::ProgramCache& programs_;
    MovingCovers covers_;
    gl::GrowingBuffer heads_, tuples_;
    gl::Buffer counts_;
    gl::Framebuffer target_;
    std::optional<PublishedCoverage> coverage_;
    std::size_t texels_ = 0, count_ = 0;  ///< when it was read last
    std::shared_ptr<gl::ForeseenCount> foreseen_ = std::make_shared<gl::ForeseenCount>();
};

}  // namespace timeshade
