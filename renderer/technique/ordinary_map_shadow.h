#pragma once

#include <optional>

#include "passes/static_map.h"
#include "technique/footprint.h"
#include "technique/technique.h"

namespace timeshade {

/// What `static` and `accumulation` have in common: one ordinary shadow map of an instant, and its test. What stands
/// still in the light's frame is kept in a map of its own, and what moves is drawn onto a copy of it.
class OrdinaryMapShadow {
  public:
    explicit OrdinaryMapShadow(gl::ProgramCache& programs) : programs_(programs) {}

    /// Declares the settings of the test: bias, slope_bias, pcf_radius.
    void visitSettings(SettingsVisitor& visitor);
    /// An instant at a point, filtered where PCF is on.
    Footprint footprint() const;
    /// Those of one map looked at in the given way.
    SamplingTraits samplingTraits(SamplingTraits::Times times, int instants) const;
    /// The instant of the plan's shutter (or of its one sample time) at which the map is drawn.
    static float instantOf(const FramePlan& plan);
    void build(const TechniqueFrame& frame);
    void lookup(const TechniqueFrame& frame);
    std::vector<const gl::Texture*> textures() const;
    std::size_t bytes() const { return (map_ ? map_->bytes() : 0) + (still_ ? still_->bytes() : 0); }

  private:
    gl::ProgramCache& programs_;
    float bias_ = 0.5f, slopeBias_ = 1.0f;
    int pcfRadius_ = 0;
    std::optional<ShadowMap> map_;    ///< of everything
    std::optional<StaticMap> still_;  ///< of what stands still, from the second time that it is the same
    std::uint64_t seen_ = 0;          ///< FramePlan::versions.casters of the time before
    bool staticAlone_ = false;        ///< nothing moves: still_ is all
};

}  // namespace timeshade
