#pragma once

#include <optional>

#include "gl/growing_buffer.h"
#include "passes/cell_lists.h"
#include "passes/moving_covers.h"
#include "techniques/temporal/tuple_lists.h"

namespace timeshade {

/// The repaired form. A tuple is a visit of the texel's centre by the triangle as it moves, with times from the roots
/// of its edge functions (shared/coverage_intervals.shared.h): several visits give several tuples, bent sides are
/// right, and both distances are linear ones. Between a tuple's ends the distance is taken as linear, which it is while
/// the triangle does not turn; else the visit is cut (at most in eight) until the chord is within a quarter of a texel.
/// Lists of exact size, 20 bytes a tuple. The coverage map claims a texel for a triangle only if its centre is inside
/// at every instant, and leaves out only tuples behind the farthest distance that the claiming triangle ever has in
/// that texel: no sample changes.
class ExactTuples final : public TupleLists {
  public:
    explicit ExactTuples(gl::ProgramCache& programs);

    void build(const TechniqueFrame& frame, const std::vector<std::uint32_t>& moving, bool coverageMap) override;
    void addInputs(gl::Inputs& inputs) const override;
    void addMarks(const FramePlan& plan, const MapLine& line, std::vector<StoredMark>& marks) const override;
    TupleCounts counts() const override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

  private:
    void drawCoverage(const TechniqueFrame& frame);

    gl::ProgramCache& programs_;
    MovingCovers covers_;
    CellLists lists_;
    gl::GrowingBuffer times_, depths_, ids_;
    gl::Buffer skipped_;
    gl::Framebuffer target_, coverageTarget_;
    std::optional<gl::Texture> coverage_;
    std::size_t tuples_ = 0;  ///< at most
};

}  // namespace timeshade
