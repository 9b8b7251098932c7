#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/setting.h"
#include "culling/caster_culling.h"
#include "passes/candidate_cost.h"
#include "passes/candidate_grid.h"
#include "technique/lookup_program.h"
#include "technique/stored_along_line.h"
#include "technique/technique_frame.h"
#include "technique/technique_statistic.h"

namespace timeshade {

/// All triangles that may shadow something, in lists by place in the light's map and time: one grid of what moves in
/// the light's frame, by cells and buckets of the shutter, and one of what stands still there, by cells, kept until it
/// changes. Casters that provably change nothing are in no list (CasterCulling): back faces of closed surfaces, seen
/// from the light, and triangles in bounding planes that no receiver is behind. What a lookup finds in them does not
/// depend on how the grids are divided.
class CandidateLists {
  public:
    explicit CandidateLists(gl::ProgramCache& programs) : programs_(programs) {}

    /// Declares the settings: side, buckets, list_all.
    void visitSettings(SettingsVisitor& visitor);
    /// The passes of build.
    std::vector<PassDecision> passes(const FramePlan& plan) const;
    /// What is culled of this plan's casters, to be added to a reason: "; 12 are culled: ...", or nothing.
    std::string culledOf(const FramePlan& plan) const;
    /// Timed as "build/static" and "build/dynamic".
    void build(const TechniqueFrame& frame);
    /// The defines and inputs that shaders/lib/candidate_lists.glsl wants.
    void addTo(LookupProgram& lookup) const;
    void addMarks(const TechniqueFrame& frame, const MapLine& line, std::vector<StoredMark>& marks) const;
    std::vector<TechniqueStatistic> statistics() const;
    /// Without the static lists, which are the frame's.
    std::size_t bytes() const { return dynamic_ ? dynamic_->bytes() : 0; }

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
};

}  // namespace timeshade
