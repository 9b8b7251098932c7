#pragma once

#include <optional>

#include "passes/stochastic_rasterizer.h"
#include "technique/technique.h"

namespace timeshade {

/// Time-dependent shadow maps (Akenine-Moller, Munkberg, Hasselgren 2007): one map
/// layer per stratum of the shutter, each texel of it drawn at a random time of the stratum; a camera sample is tested
/// in the layer of its own stratum. The times differ by up to 1/N of the shutter, 1/(3N) in the mean. Without the
/// dynamic bias a receiver that approaches the light at v per shutter shadows itself on 1/2 (1 - bias N / v)^2 of its
/// samples. What stands still in the light's frame has the same depth at all times: it is in one map beside the layers.
/// The dynamic bias of equation 12 of Andersson et al. 2015 is `eq12`. `both_times` departs from it in two ways,
/// without which a body that turns or slides along its own slopes still shadows itself: the map holds the rate at which
/// the depth over the texel changes, not the velocity of the point that is there; and the receiver is compared at the
/// map's time, too, since two surfaces that do not pass through each other keep their order.
/// `plane_test` (ours) compares once, where and when the texel looks: with the plane of the receiver's triangle at the
/// texel's centre and time. It needs no second map, takes the place of either dynamic bias and of the slope's bias, and
/// ends the self-shadow of all that is plane.
class TsmShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit TsmShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<std::string> warnings(const FramePlan& plan) const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

  private:
    enum class DynamicBias { Off, BothTimes, PointDepth };  ///< in the order of the setting's choices
    StochasticRasterizer::Strata strataOf(const FramePlan& plan) const {
        return StochasticRasterizer::Strata::ofMap(plan, strata_);
    }
    /// That which is in use: a plane test needs none.
    DynamicBias dynamicBias() const { return planeTest_ ? DynamicBias::Off : static_cast<DynamicBias>(dynamicBias_); }

    gl::ProgramCache& programs_;
    float bias_{}, slopeBias_{};
    int dynamicBias_{}, strata_{}, pcfRadius_{};
    bool planeTest_{};
    std::optional<StochasticRasterizer> rasterizer_;
    std::optional<gl::Texture> depth_, velocity_;
    const gl::Texture* staticMap_ = nullptr;  ///< the frame's
};

}  // namespace timeshade
