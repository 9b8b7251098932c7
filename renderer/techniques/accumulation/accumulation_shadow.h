#pragma once

#include "technique/ordinary_map_shadow.h"

namespace timeshade {

/// Brute force (Haeberli and Akeley 1990): the whole frame is drawn M times, each time with everything (camera, light,
/// scene) at the instant u = (m + 1/2) / M and an ordinary shadow map of that instant, and the pictures are averaged.
/// Time is sampled without noise, so an end of a shadow's interval is off by at most 1 / (2M) of the shutter; what
/// remains is the map's resolution. Every render takes one camera sample per pixel, M in all: samples per pixel have no
/// further effect.
class AccumulationShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit AccumulationShadow(gl::ProgramCache& programs) : shadow_(programs) {}

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override { return shadow_.footprint(); }
    SamplingTraits samplingTraits() const override {
        return shadow_.samplingTraits(SamplingTraits::Times::EvenInstants, renders_);
    }
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    int renders() const override { return renders_; }
    void build(const TechniqueFrame& frame) override { shadow_.build(frame); }
    void lookup(const TechniqueFrame& frame) override { shadow_.lookup(frame); }
    std::vector<const gl::Texture*> textures() const override { return shadow_.textures(); }
    std::size_t bytes() const override { return shadow_.bytes(); }

  private:
    OrdinaryMapShadow shadow_;
    int renders_ = 256;
};

}  // namespace timeshade
