#pragma once

#include <optional>

#include "technique/technique.h"
#include "technique/view_target.h"
#include "techniques/deep/visibility_map.h"

namespace timeshade {

/// Deep shadow maps (Lokovic and Veach 2000) as Andersson et al. 2015 build them for comparison (their section 6): what
/// a texel of the light's map sees at many random times of the shutter becomes a visibility function of depth, motion
/// being treated as transparency. A value is the mean over the shutter of what shadows the place where the receiver is
/// at its own time. For a receiver that stands still in the light's frame it is the true mean over the shutter, up to
///   - the texel's centre, as in any shadow map,
///   - its times: at each end of a dark interval less than the exposure of one stratum, 1 / times with a box,
///   - compression: within `error` of what the times say; 0 in front of all casters that the texel saw, and behind
///     them all (shared/visibility_function.shared.h).
/// It knows no time: a receiver that moves is shadowed by whatever is ever nearer than it there, also by itself.
/// What stands still in the light's frame is in one ordinary map.
class DeepShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    /// Of depths before compression no more than so many bytes are held at once, or one row of the map.
    static constexpr std::size_t defaultRawBytes = std::size_t{256} << 20;
    explicit DeepShadow(gl::ProgramCache& programs, std::size_t maximumRawBytes = defaultRawBytes)
        : programs_(programs), maximumRawBytes_(maximumRawBytes) {
        resetSettings(*this);
    }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::size_t bytes() const override { return map_ ? map_->bytes() : 0; }

  private:
    /// One time of each; a plan of one instant has one.
    StochasticRasterizer::Strata strataOf(const FramePlan& plan) const;

    gl::ProgramCache& programs_;
    std::size_t maximumRawBytes_;
    float error_{}, bias_{}, slopeBias_{};
    int times_{}, pcfRadius_{};
    std::optional<VisibilityMap> map_;
    ViewTarget viewTarget_;
    const gl::Texture* staticMap_ = nullptr;  ///< the frame's
};

}  // namespace timeshade
