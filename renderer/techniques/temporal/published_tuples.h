#pragma once

#include <optional>

#include "gl/growing_buffer.h"
#include "techniques/temporal/moving_covers.h"
#include "techniques/temporal/published_coverage.h"
#include "techniques/temporal/tuple_lists.h"

namespace timeshade {

/// The form of Hong and Oh 2017, mistakes included: the volume that a triangle sweeps is taken as a prism of flat
/// triangles; per texel its first and last fragment in time make one tuple, whatever lies between; times are linear in
/// the map, and so are window depths; linked lists of tuples, 20 bytes and 4 for the next; ids of the coverage map are
/// floats. It is wrong where a triangle turns (bent sides), where it visits a texel twice, where distance changes much
/// within a tuple of a spot light, and at the light's near plane. First and last fragment need no sorting here: one
/// fragment a triangle and texel finds all of the prism's at once.
class PublishedTuples final : public TupleLists {
  public:
    explicit PublishedTuples(gl::ProgramCache& programs);

    void build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& moving, bool coverageMap) override;
    void addInputs(gl::Inputs& inputs) const override;
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
    std::size_t texels_ = 0, count_ = 0;
};

}  // namespace timeshade
