#pragma once

#include <optional>

#include "culling/caster_culling.h"
#include "technique/technique.h"
#include "technique/view_target.h"
#include "techniques/exact/candidate_grid.h"

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
    explicit ExactShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::size_t bytes() const override { return dynamic_ ? dynamic_->bytes() : 0; }

  private:
    struct CasterList {
        std::vector<std::uint32_t> listed;
        std::size_t facingAway = 0;        ///< culled: back faces of closed surfaces
        std::size_t noReceiverBehind = 0;  ///< culled: in a bounding plane
        std::size_t count() const { return listed.size() + facingAway + noReceiverBehind; }
    };
    struct FrameCasters {
        CasterList dynamicOnes, staticOnes;
    };
    FrameCasters castersOf(const FramePlan& plan) const;
    static CasterList sorted(const std::optional<CasterCulling>& culling, const std::vector<std::uint32_t>& ids,
                             const std::vector<std::uint32_t>& more);
    CandidateGridSize wantedFor(const FramePlan& plan, const std::vector<std::uint32_t>& casters, bool moving) const;

    struct StaticLists {
        explicit StaticLists(gl::ProgramCache& programs) : grid(programs) {}
        std::size_t bytes() const { return grid.bytes(); }
        CandidateGrid grid;
        CandidateGridSize wanted;
        bool travel = false;  ///< some are static only in the light's frame
    };
    void buildStatic(const TechniqueFrame& frame);
    void buildDynamic(const TechniqueFrame& frame);

    gl::ProgramCache& programs_;
    int side_{}, buckets_{};
    bool listAll_{};
    mutable ClosedSurfaceCache surfaces_;
    CasterList dynamicCasters_, staticCasters_;  ///< of the frame drawn last
    CandidateGridSize wantedDynamic_;
    std::optional<CandidateGrid> dynamic_;  ///< none where nothing is dynamic in the light's frame
    const StaticLists* static_ = nullptr;   ///< the frame's; none where nothing is static in the light's frame
    ViewTarget viewTarget_;
};

}  // namespace timeshade
