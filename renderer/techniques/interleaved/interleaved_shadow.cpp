#include "techniques/interleaved/interleaved_shadow.h"

#include <fmt/format.h>

#include "shared/sample_pattern.shared.h"
#include "technique/layer_marks.h"
#include "technique/technique_entry.h"
#include "techniques/interleaved/interleaved_prediction.h"

namespace timeshade {

const TechniqueDescription& InterleavedShadow::describe() {
    static const TechniqueDescription description{
        .name = "interleaved",
        .title = "Interleaved time-dependent shadow maps",
        .shortTitle = "Interleaved TSM",
        .summary =
            "Neighbouring texels of a map layer have fixed times; each receiver is taken to all of them and "
            "tested there: little noise, no self-shadow, edges as soft as a block of texels.",
        .source = "this project; after Akenine-Moller, Munkberg, Hasselgren 2007",
        .wrong =
            "Edges: each time has every second texel of a row only. A small or thin caster falls between them, "
            "and a fast one leaves a few copies of itself, N P^2 in a shutter. Contacts within the bias are lit.",
        .look = "pillars: compare with tsm, and set the pattern to 1 and to 4.",
        .picture =
            "pillars and a map of 256 texels, left interleaved TSM, right ground truth: edges as soft as a block, "
            "and light in flutes that are shallower than the bias.",
        .references = {"T. Akenine-Moller, J. Munkberg, J. Hasselgren 2007: Stochastic rasterization using "
                       "time-continuous triangles. Graphics Hardware.",
                       "M. Andersson, J. Hasselgren, J. Munkberg, T. Akenine-Moller 2015: Filtered stochastic shadow "
                       "mapping using a layered approach. Computer Graphics Forum."},
    };
    return description;
}

void InterleavedShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("pattern", pattern_, 2, 1, 4, "texels",
                  "Side of a block of texels, each with its own time of the slice. More: more times, more tests a "
                  "sample, and edges as wide as the block.");
    visitor.number("bias", bias_, 1.0, 0.05, 64.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Hides what neighbours on a curved "
                   "surface do to each other, and with it real contacts.");
    visitor.toggle("plane_test", planeTest_, true,
                   "Compares with the receiver's plane at the texel's centre. Off: with the receiver's own depth, so "
                   "that slopes shadow themselves or need more bias.");
    visitor.whole("strata", strata_, 0, 0, maximumSamplesPerPixel, "layers",
                  "Into how many slices of the shutter the map is cut, one layer each; 0: as many as a pixel has "
                  "camera samples. More than these: as many more tests.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "blocks",
                  "Percentage-closer filtering: each phase is tested in (2n + 1) x (2n + 1) of its texels, a block "
                  "apart, and averaged. Less noise, blurred edges, costs that many tests.");
}

Footprint InterleavedShadow::footprint() const {
    Footprint footprint;
    footprint.time = Footprint::Time::Stratum;
    // The nearest texel of a phase lies within half a block of the receiver; a single test of one is no filter.
    const int width = pattern_ * (2 * pcfRadius_ + 1);
    footprint.filterTexels = width > 1 ? static_cast<double>(width) : 0.0;
    return footprint;
}

SamplingTraits InterleavedShadow::samplingTraits() const {
    return {.texelCentres = true, .biasTexels = static_cast<double>(bias_)};
}

std::shared_ptr<const Prediction> InterleavedShadow::prediction() const {
    return std::make_shared<InterleavedPrediction>(
        InterleavedPrediction::Form{pattern_, strata_, pcfRadius_, static_cast<double>(bias_), planeTest_});
}

std::vector<PassDecision> InterleavedShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes;
    if (!plan.light.staticTriangles.empty())
        passes.push_back({"build/static map",
                          "one map of what stands still in the light's frame, kept until something of it changes",
                          plan.light.staticTriangles.count()});
    if (!plan.light.dynamicTriangles.empty())
        passes.push_back({"build/strata",
                          fmt::format("{} map layers, one a slice, of what moves in the light's frame; "
                                      "{} fixed times in each, by texel; {} triangles never reach the map, "
                                      "the shadows of {} are never seen",
                                      strataOf(plan).count, pattern_ * pattern_, plan.light.outsideTriangles,
                                      plan.light.unseenTriangles),
                          plan.light.dynamicTriangles.count()});
    passes.push_back({"lookup",
                      fmt::format("each camera sample's surface point, taken to the {} times of its slice, against the "
                                  "nearest texel of each",
                                  pattern_ * pattern_),
                      0});
    return passes;
}

void InterleavedShadow::build(const TechniqueFrame& frame) {
    layers_ = strataOf(frame.plan).count;
    buildStatic(frame);
    if (frame.plan.light.dynamicTriangles.empty()) {
        depth_.reset();
        triangles_.reset();
        rasterizer_.reset();
        return;
    }
    const auto timed = frame.timer.scope("build/strata");
    const MapSize size = frame.plan.request.mapSize;
    const int layers = static_cast<int>(layers_);
    const auto fits = [&](const std::optional<gl::Texture>& map) {
        return map && MapSize(map->width(), map->height()) == size && map->layers() == layers;
    };
    if (!fits(depth_))
        depth_ = gl::Texture::array2D("interleaved depth", GL_DEPTH_COMPONENT32F, size.width, size.height, layers);
    if (planeTest_)
        triangles_.reset();
    else if (!fits(triangles_))
        triangles_ = gl::Texture::array2D("interleaved triangles", GL_R32UI, size.width, size.height, layers);
    if (!rasterizer_) rasterizer_.emplace(programs_);
    using Output = StochasticRasterizer::Output;
    rasterizer_->draw(frame.mesh, frame.plan.light, {&frame.plan.light.dynamicTriangles},
                      StochasticRasterizer::Role::Light, planeTest_ ? Output::DepthOnly : Output::TriangleId,
                      strataOf(frame.plan), triangles_ ? &*triangles_ : nullptr, *depth_);
}

/// Where nothing stands still in the light's frame there is no such map.
void InterleavedShadow::buildStatic(const TechniqueFrame& frame) {
    staticDepth_ = staticTriangles_ = nullptr;
    if (frame.plan.light.staticTriangles.empty()) return;
    const auto timed = frame.timer.scope("build/static map");
    if (planeTest_) {
        staticDepth_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Exact);
        return;
    }
    const StaticMap& map = frame.maps.ofStaticTriangles();
    staticDepth_ = &map.depth();
    staticTriangles_ = &map.triangles();
}

LookupProgram InterleavedShadow::lookupProgram(const TechniqueFrame& frame, Casters casters) {
    LookupProgram lookup{"interleaved lookup", "techniques/interleaved/lookup.frag", {}, {}};
    lookup.defines.emplace_back("PATTERN", fmt::format("{}", pattern_));
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    if (planeTest_) lookup.defines.emplace_back("PLANE_TEST", "1");
    if (strata_ > 0) {
        lookup.defines.emplace_back("OWN_STRATA", "1");
        lookup.inputs.set("layers", layers_).set("layerLength", strataOf(frame.plan).length);
    }
    if (staticDepth_ != nullptr) {
        lookup.defines.emplace_back("STATIC_CASTERS", "1");
        lookup.inputs.texture("staticMap", *staticDepth_);
        if (staticTriangles_ != nullptr) lookup.inputs.texture("staticTriangles", *staticTriangles_);
    }
    if (depth_ && casters == Casters::All) {
        lookup.defines.emplace_back("DYNAMIC_CASTERS", "1");
        lookup.inputs.texture("depthMap", *depth_);
        if (triangles_) lookup.inputs.texture("triangleMap", *triangles_);
    }
    return lookup;
}

StoredAlongLine InterleavedShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    const FramePlan& plan = frame.plan;
    const StochasticRasterizer::Strata strata = strataOf(plan);
    if (staticDepth_ != nullptr) addMapMarks(plan, *staticDepth_, line, 0.0, 1.0, stored.marks);
    stored.note = fmt::format(
        "one map of what stands still, and {} layers: a point is a texel at its fixed time, one "
        "of {} in a layer",
        strata.count, pattern_ * pattern_);
    if (!depth_) return stored;
    const auto side = static_cast<std::uint32_t>(pattern_);
    const auto timeOf = [&](glm::uvec2 texel, std::uint32_t layer) {
        const float within = shared::phaseTime(shared::texelPhase(texel, side), side);
        return shared::sampleTime(plan.block.timeBase, strata.length, layer, within);
    };
    addLayerMarks(plan, *depth_, line, timeOf, stored.marks);
    return stored;
}

std::vector<TechniqueStatistic> InterleavedShadow::statistics() const {
    return {{"times of the map", static_cast<double>(layers_) * pattern_ * pattern_, "", ""}};
}

std::vector<const gl::Texture*> InterleavedShadow::textures() const {
    return depth_ ? std::vector<const gl::Texture*>{&*depth_} : std::vector<const gl::Texture*>{};
}

std::size_t InterleavedShadow::bytes() const {
    return (depth_ ? depth_->bytes() : 0) + (triangles_ ? triangles_->bytes() : 0) +
           (rasterizer_ ? rasterizer_->bytes() : 0);
}

TechniqueEntry interleavedTechnique() { return entryOf<InterleavedShadow>(); }

}  // namespace timeshade
