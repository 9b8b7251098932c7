#include "techniques/tsm/tsm_shadow.h"

#include <fmt/format.h>

#include "technique/technique_entry.h"

namespace timeshade {

namespace {

/// The dynamic bias: a depth is moved along the plane of what the texel saw to the receiver's time.
class DynamicBiasPrediction final : public Prediction {
  public:
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override {
        const TriangleInMap& triangle = receiver.triangles[caster];
        if (!hitOf(triangle, position, v).inside) return std::nullopt;
        return hitOf(triangle, position, u).distance;
    }
};

}  // namespace

const TechniqueDescription& TsmShadow::describe() {
    static const TechniqueDescription description{
        .name = "tsm",
        .title = "Time-dependent shadow maps",
        .shortTitle = "TSM",
        .summary =
            "One stochastic map layer per stratum of the shutter: right in the mean for slow casters, noisy, and "
            "receivers that move towards the light shadow themselves.",
        .source = "Akenine-Moller, Munkberg, Hasselgren 2007; dynamic bias: Andersson et al. 2015, eq. 12",
        .wrong =
            "Noise, which more samples end. A receiver that approaches the light within a stratum shadows itself: map "
            "and camera sample look at different times.",
        .look = "pillars: everything lit is speckled; switch dynamic bias on and the speckles go.",
        .picture = "pillars, left TSM, right ground truth: speckles, and noise along the edges.",
        .references = {"T. Akenine-Moller, J. Munkberg, J. Hasselgren 2007: Stochastic rasterization using "
                       "time-continuous triangles. Graphics Hardware.",
                       "M. Andersson, J. Hasselgren, J. Munkberg, T. Akenine-Moller 2015: Filtered stochastic shadow "
                       "mapping using a layered approach. Computer Graphics Forum."},
    };
    return description;
}

void TsmShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 64.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Hides the self-shadow of receivers "
                   "that approach the light, and with it real contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.toggle("dynamic_bias", dynamicBias_, false,
                   "Compares map and receiver at both of their times: each depth is moved at its own rate to the "
                   "other's time (after "
                   "Andersson et al. 2015, eq. 12). Ends the self-shadow; costs one more map of rates.");
}

SamplingTraits TsmShadow::samplingTraits() const {
    return {.times = SamplingTraits::Times::RandomInStratum,
            .texelCentres = true,
            .biasTexels = static_cast<double>(bias_)};
}

std::shared_ptr<const Prediction> TsmShadow::prediction() const {
    return dynamicBias_ ? std::make_shared<DynamicBiasPrediction>() : Technique::prediction();
}

std::vector<PassDecision> TsmShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes;
    passes.push_back({"build/static map",
                      "one map of what stands still in the light's frame, kept until something of it changes",
                      plan.light.staticTriangles.count()});
    if (!plan.light.dynamicTriangles.empty())
        passes.push_back({"build/strata",
                          fmt::format("{} map layers, one a stratum, each texel at its own random time, of what moves "
                                      "in the light's frame; {} "
                                      "triangles never reach the map, the shadows of {} are never seen",
                                      plan.block.strata, plan.light.outsideTriangles, plan.light.unseenTriangles),
                          plan.light.dynamicTriangles.count()});
    passes.push_back({"lookup",
                      plan.light.dynamicTriangles.empty()
                          ? "nothing moves in the light's frame: each camera sample against the one map"
                          : "each camera sample against the one map and the layer of its own stratum",
                      0});
    return passes;
}

void TsmShadow::build(const TechniqueFrame& frame) {
    {
        const auto timed = frame.timer.scope("build/static map");
        staticMap_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Exact);
    }
    if (frame.plan.light.dynamicTriangles.empty()) {
        depth_.reset();
        velocity_.reset();
        rasterizer_.reset();
        return;
    }
    const auto timed = frame.timer.scope("build/strata");
    const int size = frame.plan.request.mapSize, layers = static_cast<int>(frame.plan.block.strata);
    const auto fits = [&](const std::optional<gl::Texture>& map) {
        return map && map->width() == size && map->layers() == layers;
    };
    if (!fits(depth_)) depth_ = gl::Texture::array2D("tsm depth", GL_DEPTH_COMPONENT32F, size, size, layers);
    if (!dynamicBias_)
        velocity_.reset();
    else if (!fits(velocity_))
        velocity_ = gl::Texture::array2D("tsm depth velocity", GL_R32F, size, size, layers);
    if (!rasterizer_) rasterizer_.emplace(programs_);
    using Output = StochasticRasterizer::Output;
    rasterizer_->draw(frame.mesh, frame.plan.light, {&frame.plan.light.dynamicTriangles},
                      StochasticRasterizer::Role::Light, dynamicBias_ ? Output::DepthVelocity : Output::DepthOnly,
                      frame.plan.block.strata, velocity_ ? &*velocity_ : nullptr, *depth_);
}

LookupProgram TsmShadow::lookupProgram(const TechniqueFrame&, Casters) {
    LookupProgram lookup{"tsm lookup", "techniques/tsm/lookup.frag", {}, {}};
    lookup.inputs.texture("staticMap", *staticMap_);
    if (depth_) {
        lookup.defines.emplace_back("DYNAMIC_CASTERS", "1");
        lookup.inputs.texture("depthMap", *depth_);
    }
    if (dynamicBias_) lookup.defines.emplace_back("DYNAMIC_BIAS", "1");
    if (velocity_) lookup.inputs.texture("velocityMap", *velocity_);
    return lookup;
}

std::vector<const gl::Texture*> TsmShadow::textures() const {
    std::vector<const gl::Texture*> all;
    for (const auto* texture : {&depth_, &velocity_})
        if (*texture) all.push_back(&**texture);
    return all;
}

std::size_t TsmShadow::bytes() const {
    return (depth_ ? depth_->bytes() : 0) + (velocity_ ? velocity_->bytes() : 0) +
           (rasterizer_ ? rasterizer_->bytes() : 0);
}

TechniqueEntry tsmTechnique() { return entryOf<TsmShadow>(); }

}  // namespace timeshade
