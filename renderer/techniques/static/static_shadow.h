#pragma once

#include <optional>

#include "passes/map_fit.h"
#include "passes/shadow_map.h"
#include "technique/ordinary_map.h"

namespace timeshade {

/// One ordinary shadow map at the middle of the shutter, whatever moves: what most engines do, and wrong on purpose.
/// Shadows of moving casters are sharp where they should be blurred. It covers all that the light reaches, or, as
/// engines do too, what the camera sees of it (Brabec et al. 2002), with or without a perspective warp (Wimmer,
/// Scherzer, Purgathofer 2004); then it is a map of the technique's own, drawn in every frame.
class StaticShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit StaticShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override { return map_.footprint(); }
    SamplingTraits samplingTraits() const override { return map_.samplingTraits(); }
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    std::vector<std::string> warnings(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    /// A fitted map holds all casters.
    bool separatesStaticCasters() const override { return fit() == MapFit::Light; }
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override { return fitted_ ? fitted_->bytes() : 0; }

  private:
    MapFit fit() const { return static_cast<MapFit>(fit_); }

    gl::ProgramCache& programs_;
    OrdinaryMap map_;
    int fit_{};
    std::optional<ShadowMap> fitted_;
    glm::dmat3 mapFromPlane_{1.0};  ///< of the map drawn last
};

}  // namespace timeshade
