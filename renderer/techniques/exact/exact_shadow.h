#pragma once

#include "technique/candidate_lists.h"
#include "technique/technique.h"
#include "technique/view_target.h"

namespace timeshade {

/// Exact shadows at every sample. Each cell of a grid over the shadow map lists the triangles that may shadow something
/// in it, per interval of the shutter; each camera sample tests those of its cell and interval by the definition itself
/// (docs/numerics.md, "Definition of shadow"): the segment from its receiver to the light at its own time, against the
/// triangles at that time. No time mismatch, no spatial aliasing, no bias; the grid and the intervals change time and
/// memory only. Error: samples whose segment passes an edge within the rounding of floats (about 4e-7 of the
/// distances). An extension in time of irregular shadow mapping (Johnson et al. 2005) and hybrid ray-traced shadows
/// (Story 2015).
///
/// Casters that provably change nothing are in no list (CasterCulling): back faces of closed surfaces, seen from the
/// light, and triangles in bounding planes that no receiver is behind.
class ExactShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit ExactShadow(gl::ProgramCache& programs) : programs_(programs), lists_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override { lists_.build(frame); }
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override { return lists_.statistics(); }
    std::size_t bytes() const override { return lists_.bytes(); }

  private:
    gl::ProgramCache& programs_;
    CandidateLists lists_;
    ViewTarget viewTarget_;
};

}  // namespace timeshade
