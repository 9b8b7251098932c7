#pragma once

#include "technique/ordinary_map.h"

namespace timeshade {

/// Brute force (Haeberli and Akeley 1990): the whole frame is drawn M times, each time with everything (camera, light,
/// scene) at the instant u = (m + 1/2) / M and an ordinary shadow map of that instant, and the pictures are averaged.
/// Time is sampled without noise, so an end of a shadow's interval is off by at most 1 / (2M) of the shutter; what
/// remains is the map's resolution. Every render takes one camera sample per pixel, M in all: samples per pixel have no
/// further effect.
class AccumulationShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit AccumulationShadow(gl::ProgramCache&) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override { return map_.footprint(); }
    SamplingTraits samplingTraits() const override { return map_.samplingTraits(); }
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    int renders() const override { return renders_; }
    void build(const TechniqueFrame& frame) override { map_.build(frame); }
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override {
        return map_.lookupProgram(frame, casters);
    }
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::size_t bytes() const override { return 0; }

  private:
    OrdinaryMap map_;
    int renders_{};
};

}  // namespace timeshade
