#pragma once

#include <optional>

#include "passes/stochastic_rasterizer.h"
#include "technique/technique.h"
#include "technique/view_target.h"
#include "techniques/layers/layer_grids.h"

namespace timeshade {

/// Filtered layered shadow maps (Andersson, Hasselgren, Munkberg, Akenine-Moller 2015). A time-dependent map with the
/// motion of what each sample sees is converted to layers of tiles (LayerGrids), and a camera sample is answered by a
/// filtered lookup in each: an estimate of the mean visibility over its stratum, not a single test.
///
/// `as_published`: the paper's steps, with every triangle in the layers. Otherwise repaired: what stands still in the
/// light's frame is in an ordinary map; the footprint is the sample's own stratum, with the receiver followed on its
/// triangle; paths are straight in space, not in the map; each cell is tested on its own against the receiver's plane,
/// lit where the receiver is nearer than the mean, and beyond a layer's range without the variance test; moments are
/// about the layer's middle; where motions in a layer differ too much for their mean to mean anything, the samples
/// themselves are tested.
class LayersShadow final : public Technique {
  public:
    static const TechniqueDescription& describe();
    explicit LayersShadow(gl::ProgramCache& programs) : programs_(programs) { resetSettings(*this); }

    const TechniqueDescription& description() const override { return describe(); }
    void visitSettings(SettingsVisitor& visitor) override;
    Footprint footprint() const override;
    SamplingTraits samplingTraits() const override;
    std::shared_ptr<const Prediction> prediction() const override;
    /// Its filter reaches beyond where dynamic casters can shadow anything, so a frame may not tell by those what to
    /// draw anew.
    bool separatesStaticCasters() const override { return false; }
    std::vector<PassDecision> passes(const FramePlan& plan) const override;
    void build(const TechniqueFrame& frame) override;
    LookupProgram lookupProgram(const TechniqueFrame& frame, Casters casters) override;
    std::vector<TechniqueView> views() const override;
    void drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) override;
    StoredAlongLine storedAlong(const TechniqueFrame& frame, const MapLine& line) override;
    std::vector<const gl::Texture*> textures() const override;
    std::size_t bytes() const override;

  private:
    StochasticRasterizer::Strata strataOf(const FramePlan& plan) const {
        return StochasticRasterizer::Strata::ofMap(plan, strata_);
    }
    LayerGrids::Options optionsOf() const;
    bool hasCasters(const FramePlan& plan) const;

    gl::ProgramCache& programs_;
    float bias_{}, slopeBias_{};
    int strata_{}, layers_{}, tiles_{}, shownLayer_{};
    bool asPublished_{}, equation9Alone_{}, neighbourTiles_{}, filterAcross_{};
    std::optional<StochasticRasterizer> rasterizer_;
    std::optional<gl::Texture> depth_, motion_;
    std::optional<LayerGrids> grids_;
    ViewTarget viewTarget_;
    const gl::Texture* staticMap_ = nullptr;  ///< the frame's
};

}  // namespace timeshade
