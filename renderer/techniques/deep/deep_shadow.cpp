#include "techniques/deep/deep_shadow.h"

#include <algorithm>

#include <fmt/format.h>

#include "technique/technique_entry.h"
#include "techniques/deep/deep_prediction.h"

namespace timeshade {

const TechniqueDescription& DeepShadow::describe() {
    static const TechniqueDescription description{
        .name = "deep",
        .title = "Deep shadow maps",
        .shortTitle = "Deep",
        .summary =
            "Each texel holds how much of the shutter passes a depth, from 128 random times: smooth shadows on what "
            "stands still, wrong ones on what moves.",
        .source = "Lokovic, Veach 2000; with motion as Andersson et al. 2015, section 6",
        .wrong =
            "Receivers that move in the light's frame: a texel knows how long something was nearer, not when, so that "
            "they are shadowed by what has passed, and by themselves.",
        .look = "pillars: the light moves, and with it all receivers; rising: the cubes darken their own tops.",
        .picture = "pillars, left deep, right ground truth: shadows smeared, and what is lit is dark as well.",
        .references = {"T. Lokovic, E. Veach 2000: Deep shadow maps. SIGGRAPH.",
                       "M. Andersson, J. Hasselgren, J. Munkberg, T. Akenine-Moller 2015: Filtered stochastic shadow "
                       "mapping using a layered approach. Computer Graphics Forum."},
    };
    return description;
}

void DeepShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("times", times_, 128, 1, VisibilityMap::maximumTimes, "times",
                  "Into how many strata of the shutter the map is cut, each texel drawn at one random time of each. "
                  "More: less noise, and that much more to draw and to keep while building.");
    visitor.number("error", error_, 0.03, 0.0, 0.5, "of visibility",
                   "How far the compressed visibility function may be from what the times say. 0 keeps all.");
    visitor.number("bias", bias_, 0.5, 0.0, 64.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Hides the self-shadow of receivers "
                   "that approach the light, and with it real contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering: the visibility in (2n + 1) x (2n + 1) texels, averaged. Softens the "
                  "map's steps, costs that many lookups.");
}

Footprint DeepShadow::footprint() const {
    Footprint footprint;
    footprint.time = Footprint::Time::Shutter;
    footprint.filterTexels = Footprint::filterOf(pcfRadius_);
    return footprint;
}

SamplingTraits DeepShadow::samplingTraits() const {
    // Each end of the dark interval lies in some stratum, of which one time decides.
    return {.times = SamplingTraits::Times::RandomInStratum,
            .strata = times_,
            .texelCentres = true,
            .biasTexels = static_cast<double>(bias_),
            .statedError = 2.0 / times_ + static_cast<double>(error_)};
}

std::shared_ptr<const Prediction> DeepShadow::prediction() const {
    return std::make_shared<DeepPrediction>(static_cast<double>(bias_), pcfRadius_);
}

StochasticRasterizer::Strata DeepShadow::strataOf(const FramePlan& plan) const {
    const float open = plan.block.timeScale * static_cast<float>(plan.block.strata);
    if (open == 0.0f) return {1, 0.0f};
    return {static_cast<std::uint32_t>(times_), open / static_cast<float>(times_)};
}

std::vector<PassDecision> DeepShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes;
    passes.push_back({"build/static map",
                      "one map of what stands still in the light's frame, kept until something of it changes",
                      plan.light.staticTriangles.count()});
    const bool moves = !plan.light.dynamicTriangles.empty();
    if (moves) {
        const std::uint32_t times = strataOf(plan).count;
        const std::size_t raw = plan.request.mapSize.texels() * times * sizeof(float);
        passes.push_back({"build/times",
                          fmt::format("each texel at {} random times, of what moves in the light's frame: {:.0f} MiB "
                                      "of depths{}; {} triangles never reach the map, the shadows of {} are never seen",
                                      times, static_cast<double>(raw) / (1024.0 * 1024.0),
                                      raw > maximumRawBytes_ ? ", some rows after the other, twice" : "",
                                      plan.light.outsideTriangles, plan.light.unseenTriangles),
                          plan.light.dynamicTriangles.count()});
        passes.push_back({"build/compress", "a visibility function a texel, within deep.error of its depths", 0});
    }
    passes.push_back({"lookup",
                      moves ? "each camera sample against the one map and the visibility function of its texel"
                            : "nothing moves in the light's frame: each camera sample against the one map",
                      0});
    return passes;
}

void DeepShadow::build(const TechniqueFrame& frame) {
    {
        const auto timed = frame.timer.scope("build/static map");
        staticMap_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Exact);
    }
    if (frame.plan.light.dynamicTriangles.empty()) {
        map_.reset();
        return;
    }
    if (!map_) map_.emplace(programs_, maximumRawBytes_);
    map_->build(frame, strataOf(frame.plan));
}

LookupProgram DeepShadow::lookupProgram(const TechniqueFrame&, Casters casters) {
    LookupProgram lookup{"deep lookup", "techniques/deep/lookup.frag", {}, {}};
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    lookup.inputs.texture("staticMap", *staticMap_);
    if (map_) {
        lookup.defines.emplace_back("DYNAMIC_CASTERS", "1");
        if (casters == Casters::All) map_->addInputs(lookup.inputs);
    }
    return lookup;
}

std::vector<TechniqueView> DeepShadow::views() const {
    return {{"nodes", "Nodes of the visibility function", "nodes", 0.0, 32.0, false},
            {"light", "Nodes as the light sees them", "nodes", 0.0, 32.0, false}};
}

void DeepShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "nodes" && name != "light") return Technique::drawView(frame, name, values);
    if (!map_) {  // functions of nothing, to be looked at
        map_.emplace(programs_, maximumRawBytes_);
        map_->build(frame, strataOf(frame.plan));
    }
    gl::ShaderDefines defines = frame.defines();
    if (name == "light") defines.emplace_back("SEEN_BY_LIGHT", "1");
    const gl::Program& program =
        programs_.get({"deep view", "passes/fullscreen.vert", "techniques/deep/view.frag", defines});
    gl::Inputs inputs;
    map_->addInputs(inputs);
    program.use(inputs);
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    viewTarget_.bind(values);
    frame.fullscreen.draw(program);
}

StoredAlongLine DeepShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    if (staticMap_ != nullptr) addMapMarks(frame.plan, *staticMap_, line, 0.0, 1.0, stored.marks);
    if (map_) map_->addMarks(frame.plan, line, stored.marks);
    stored.note = "what moves is there at all times, as transparent as the share of the shutter that it leaves free";
    return stored;
}

std::vector<TechniqueStatistic> DeepShadow::statistics() const {
    if (!map_) return {};
    const VisibilityMapCounts counts = map_->counts();
    const auto number = [](std::size_t n) { return static_cast<double>(n); };
    const double texels = number(std::max<std::size_t>(counts.texelsInUse, 1));
    return {
        {"texels in use", number(counts.texelsInUse), "texels", ""},
        {"times per texel in use", number(counts.hits) / texels, "times", ""},
        {"nodes per texel in use", number(counts.nodes) / texels, "nodes", ""},
        {"most nodes", number(counts.mostNodes), "nodes", ""},
        {"bytes per texel in use", number(map_->functionBytes()) / texels, "bytes", ""},
        {"depths before compression", number(map_->rawBytes()), "bytes", ""},
    };
}

TechniqueEntry deepTechnique() { return entryOf<DeepShadow>(); }

}  // namespace timeshade
