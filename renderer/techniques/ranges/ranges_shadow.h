#pragma once

#include <memory>
#include <optional>

#include "passes/near_triangles.h"
#include "technique/technique.h"
#include "technique/view_target.h"
#include "techniques/ranges/range_lists.h"

namespace timeshade {

/// Depth-time ranges (Hong and Oh 2019). The volume that a moving triangle sweeps in the light's map is drawn as a
/// closed surface, a prism; where it covers a texel, fragments say when the triangle comes and when it goes, and how
/// far away: a range (begin, end, depth at begin, depth at end, triangle). A receiver is in shadow if a range of its
/// texel holds its time and is nearer than it. No time is sampled for the map, so there is no time mismatch. Fragments
/// also keep how time and distance change across the texel (which the paper's do not), so that an edge that sweeps over
/// texels is placed where the receiver is, not where the texel's centre is; no farther than the edge itself reaches.
/// Exact to the texel where a triangle moves without turning (its sides are flat then); where it turns or deforms, the
/// sides are bilinear, the fans that stand for them are corrected to first order, and what is left are some thousandths
/// (means of .002, .005, .013 of the shutter at 5, 15, 45 degrees of turn; without the correction .006, .014, .027).
/// Still triangles go to an ordinary map. Triangles that cross the light's near plane have no prism: each sample tests
/// them exactly. `as_published` is the paper step by step: see LinkedRanges.
class RangesShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit RangesShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    bool separatesStaticCasters() const override { return !asPublished_; }
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::size_t bytes() const override;

  private:
    /// The plan's casters, by the form's own way of listing them.
    LightMotion listed(const FramePlan& plan) const;
    void buildLists(const TechniqueFrame& frame, const LightMotion& motion);
    std::size_t predictedBytes(const RangeCounts& counts) const;

    gl::ProgramCache& programs_;
    float bias_{}, slopeBias_{}, publishedBias_{};
    int pcfRadius_{};
    bool asPublished_{};

    bool builtAsPublished_ = false;
    std::unique_ptr<RangeLists> lists_;       ///< none where nothing moves
    const gl::Texture* staticMap_ = nullptr;  ///< the frame's; none as published
    NearTriangles near_;
    std::size_t staticCasters_ = 0, moving_ = 0, nonTranslating_ = 0;
    ViewTarget viewTarget_;
};

}  // namespace timeshade
