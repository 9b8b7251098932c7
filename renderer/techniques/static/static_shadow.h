#pragma once

#include "technique/ordinary_map.h"

namespace timeshade {

/// One ordinary shadow map at the middle of the shutter, whatever moves: what most engines do, and wrong on purpose.
/// Shadows of moving casters are sharp where they should be blurred.
class StaticShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit StaticShadow(gl::ProgramCache&) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override { map_.visitSettings(visitor); }
    Footprint footprint() const override { return map_.footprint(); }
    SamplingTraits samplingTraits() const override { return map_.samplingTraits(); }
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override { map_.build(frame); }
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override {
        return map_.lookupProgram(frame, casters);
    }
    std::size_t bytes() const override { return 0; }

  private:
    OrdinaryMap map_;
};

}  // namespace timeshade
