#include "techniques/tsm/tsm_shadow.h"

#include <algorithm>

#include <fmt/format.h>

#include "shared/sample_pattern.shared.h"
#include "technique/layer_marks.h"
#include "technique/technique_entry.h"

namespace timeshade {

namespace {

/// `both_times`: a depth is moved along the plane of what the texel saw to the receiver's time, and the receiver's
/// along its own to the map's; a caster that is nearer at one of the times alone is none. The farther of the two
/// decides.
class BothTimesPrediction final : public Prediction {
  public:
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override {
        const TriangleInMap& triangle = receiver.triangles[caster];
        const PlaneHit hit = hitOf(triangle, position, v);
        if (!hit.inside) return std::nullopt;
        const glm::dvec3 p = receiver.path.at(u);
        const double later = hitOf(receiver.triangles[receiver.own], glm::dvec2(p) / p.z, v).distance;
        return std::max(hitOf(triangle, position, u).distance, hit.distance + p.z - later);
    }
};

/// `eq12`: a depth changes as that of the point does which the texel saw.
class PointDepthPrediction final : public Prediction {
  public:
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override {
        const TriangleInMap& triangle = receiver.triangles[caster];
        const PlaneHit hit = hitOf(triangle, position, v);
        if (!hit.inside) return std::nullopt;
        glm::dvec3 rates;
        for (int i = 0; i < 3; ++i) rates[i] = triangle.corners[i].close.z - triangle.corners[i].open.z;
        return hit.distance + glm::dot(hit.inSpace, rates) * (u - v);
    }
};

/// `plane_test`: as far nearer or farther than the receiver as the caster is than the receiver's plane, seen through
/// the texel's centre at the map's time; at the receiver's for a caster that is in the one map of what stands still.
class PlaneTestPrediction final : public Prediction {
  public:
    std::optional<double> casterDistance(const ReceiverInMap& receiver, std::size_t caster, const glm::dvec2& position,
                                         double u, double v) const override {
        const TriangleInMap& triangle = receiver.triangles[caster];
        const PlaneHit hit = hitOf(triangle, position, v);
        if (!hit.inside || hit.distance <= receiver.nearDistance) return std::nullopt;
        const bool standsStill = std::all_of(std::begin(triangle.corners), std::end(triangle.corners),
                                             [](const PathInMap& corner) { return corner.open == corner.close; });
        const PlaneHit plane = hitOf(receiver.triangles[receiver.own], position, standsStill ? u : v);
        return hit.distance * receiver.path.at(u).z / plane.distance;
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
    visitor.choice(
        "dynamic_bias", dynamicBias_, static_cast<int>(DynamicBias::Off), {"off", "both_times", "eq12"},
        "Moves depths of the map to the receiver's time. eq12: at the velocity of the point that the texel "
        "saw, one test (Andersson et al. 2015, eq. 12, as it stands). both_times: at the rate at which the "
        "texel's depth changes, and the receiver's depth to the map's time as well, two tests (ours); it ends "
        "the self-shadow. Either costs one more map.");
    visitor.toggle("plane_test", planeTest_, false,
                   "Compares with the receiver's plane at the texel's centre and time, by the one bias: no slope bias, "
                   "no dynamic bias, no second map (ours).");
    visitor.whole(
        "strata", strata_, 0, 0, maximumSamplesPerPixel, "layers",
        "Into how many strata of the shutter the map is cut, one layer each; 0: as many as a pixel has camera "
        "samples. More: times that differ less, and that much more memory.");
    visitor.whole(
        "pcf_radius", pcfRadius_, 0, 0, 3, "texels",
        "Percentage-closer filtering: the test is made in (2n + 1) x (2n + 1) texels of the layer, each at its "
        "own time, and averaged. Less noise, blurred edges, costs that many tests.");
}

Footprint TsmShadow::footprint() const {
    Footprint footprint;
    footprint.filterTexels = Footprint::filterOf(pcfRadius_);
    return footprint;
}

SamplingTraits TsmShadow::samplingTraits() const {
    return {.times = SamplingTraits::Times::RandomInStratum,
            .strata = strata_,
            .texelCentres = true,
            .biasTexels = static_cast<double>(bias_)};
}

std::shared_ptr<const Prediction> TsmShadow::prediction() const {
    if (planeTest_) return std::make_shared<PlaneTestPrediction>();
    switch (dynamicBias()) {
    case DynamicBias::Off: break;
    case DynamicBias::BothTimes: return std::make_shared<BothTimesPrediction>();
    case DynamicBias::PointDepth: return std::make_shared<PointDepthPrediction>();
    }
    return Technique::prediction();
}

std::vector<std::string> TsmShadow::warnings(const FramePlan&) const {
    if (!planeTest_ || dynamicBias_ == 0) return {};
    return {"dynamic_bias is left out: plane_test compares at the map's own time"};
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
                                      strataOf(plan).count, plan.light.outsideTriangles, plan.light.unseenTriangles),
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
    const StochasticRasterizer::Strata strata = strataOf(frame.plan);
    const MapSize size = frame.plan.request.mapSize;
    const int layers = static_cast<int>(strata.count);
    const auto fits = [&](const std::optional<gl::Texture>& map) {
        return map && MapSize(map->width(), map->height()) == size && map->layers() == layers;
    };
    if (!fits(depth_))
        depth_ = gl::Texture::array2D("tsm depth", GL_DEPTH_COMPONENT32F, size.width, size.height, layers);
    using Output = StochasticRasterizer::Output;
    static constexpr Output outputs[] = {Output::DepthOnly, Output::DepthRate, Output::DepthVelocity};
    if (dynamicBias() == DynamicBias::Off)
        velocity_.reset();
    else if (!fits(velocity_))
        velocity_ = gl::Texture::array2D("tsm depth velocity", GL_R32F, size.width, size.height, layers);
    if (!rasterizer_) rasterizer_.emplace(programs_);
    rasterizer_->draw(frame.mesh, frame.plan.light, {&frame.plan.light.dynamicTriangles},
                      StochasticRasterizer::Role::Light, outputs[static_cast<int>(dynamicBias())], strata,
                      velocity_ ? &*velocity_ : nullptr, *depth_);
}

LookupProgram TsmShadow::lookupProgram(const TechniqueFrame& frame, Casters) {
    LookupProgram lookup{
        "tsm lookup", planeTest_ ? "techniques/tsm/plane_test.frag" : "techniques/tsm/lookup.frag", {}, {}};
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    if (strata_ > 0) lookup.defines.emplace_back("OWN_STRATA", "1");
    lookup.inputs.texture("staticMap", *staticMap_);
    const StochasticRasterizer::Strata strata = strataOf(frame.plan);
    lookup.inputs.set("layers", strata.count).set("layerLength", strata.length);
    if (depth_) {
        lookup.defines.emplace_back("DYNAMIC_CASTERS", "1");
        lookup.inputs.texture("depthMap", *depth_);
    }
    if (dynamicBias() != DynamicBias::Off) lookup.defines.emplace_back("DYNAMIC_BIAS", "1");
    if (dynamicBias() == DynamicBias::BothTimes) lookup.defines.emplace_back("BOTH_TIMES", "1");
    if (velocity_) lookup.inputs.texture("velocityMap", *velocity_);
    return lookup;
}

StoredAlongLine TsmShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    const FramePlan& plan = frame.plan;
    const StochasticRasterizer::Strata strata = strataOf(plan);
    addMapMarks(plan, *staticMap_, line, 0.0, 1.0, stored.marks);
    stored.note =
        fmt::format("one map of what stands still, and {} layers: a point is a texel at its own time", strata.count);
    if (!depth_) return stored;
    const auto timeOf = [&](glm::uvec2 texel, std::uint32_t layer) {
        const std::uint32_t k = plan.block.firstStratum + layer;
        const float xi = shared::samplePattern(texel, k, plan.block.seed, SALT_LIGHT).z;
        return shared::sampleTime(plan.block.timeBase, strata.length, layer, xi);
    };
    addLayerMarks(plan, *depth_, line, timeOf, stored.marks);
    return stored;
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
