#pragma once

#include "technique/ordinary_map_shadow.h"

namespace timeshade {

/// One ordinary shadow map at the middle of the shutter, whatever moves: what most engines do, and wrong on purpose.
/// Shadows of moving casters are sharp where they should be blurred.
class StaticShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit StaticShadow(gl::ProgramCache& programs) : shadow_(programs) {}

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override { shadow_.visitSettings(visitor); }
    Footprint footprint() const override { return shadow_.footprint(); }
    SamplingTraits samplingTraits() const override {
        return shadow_.samplingTraits(SamplingTraits::Times::OneInstant, 1);
    }
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override { shadow_.build(frame); }
    void lookup(const TechniqueFrame& frame) override { shadow_.lookup(frame); }
    std::vector<const gl::Texture*> textures() const override { return shadow_.textures(); }
    std::size_t bytes() const override { return shadow_.bytes(); }

  private:
    OrdinaryMapShadow shadow_;
};

}  // namespace timeshade
