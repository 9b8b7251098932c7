#pragma once

#include <optional>

#include "passes/stochastic_rasterizer.h"
#include "technique/technique.h"

namespace timeshade {

/// Time-dependent shadow maps of fixed times (ours; docs/numerics.md, "Fixed times"): one map layer per slice of the
/// shutter, in which the texel (x, y) is drawn at the time of the phase phi = x mod P + P (y mod P),
///     t = (k + (phi + 1/2) / P^2) / N.
/// A lookup takes the receiver, as a point of its triangle, to each of
/// the P^2 times of its slice and tests it in the nearest texel of that phase: not against its own triangle, and by the
/// depth of its own plane at the texel's centre. The value is the mean of P^2 tests, an estimate of the mean over the
/// slice in which casters and receiver are always seen at the same time: nothing that moves shadows itself. An end of a
/// shadow in time is off by at most 1/2 of 1 / (N P^2), in space by P / 2 texels.
/// What stands still in the light's frame is in one map beside the layers and is tested in the same texels.
/// The receiver's own triangle has the depth of its plane, so that the plane test leaves it out by itself; without that
/// test both maps hold the number of each texel's triangle as well. Memory: 4 bytes a texel and layer, or 8.
class InterleavedShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit InterleavedShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<TechniqueStatistic> statistics() const override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

  private:
    StochasticRasterizer::Strata strataOf(const FramePlan& plan) const {
        return StochasticRasterizer::Strata::ofMap(plan, strata_, pattern_);
    }
    void buildStatic(const TechniqueFrame& frame);

    gl::ProgramCache& programs_;
    int pattern_{};  ///< P
    int strata_{}, pcfRadius_{};
    float bias_{};
    bool planeTest_{};
    std::optional<StochasticRasterizer> rasterizer_;
    std::optional<gl::Texture> depth_, triangles_;
    const gl::Texture *staticDepth_ = nullptr, *staticTriangles_ = nullptr;  ///< the frame's, or none
    std::uint32_t layers_ = 0;
};

}  // namespace timeshade
