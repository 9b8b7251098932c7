#include "techniques/temporal/temporal_shadow.h"

#include <algorithm>

#include <fmt/format.h>

#include "plan/light_motion.h"
#include "technique/technique_entry.h"
#include "techniques/temporal/bindings.shared.h"
#include "techniques/temporal/exact_tuples.h"
#include "techniques/temporal/published_tuples.h"
#include "techniques/temporal/published_tuples_prediction.h"

namespace timeshade {

const TechniqueDescription& TemporalShadow::describe() {
    static const TechniqueDescription description{
        .name = "temporal",
        .title = "Temporal shadow maps",
        .shortTitle = "Temporal",
        .summary =
            "Lists, per map texel, of when each moving triangle is there and how far away: each triangle is drawn once "
            "for the whole shutter, memory grows with what moves.",
        .source = "Hong and Oh 2017",
        .wrong = "Space, not time: a texel answers for its centre, so that edges follow the map's grid.",
        .look =
            "pillars, camera between, map 256: steps along the edges, but no noise; its view of list lengths shows "
            "what it pays for.",
        .picture = "pillars, left temporal with a map of 256, right ground truth.",
        .references = {"M. Hong, K. Oh 2017: Efficient motion blurred shadows using a temporal shadow map."},
    };
    return description;
}

void TemporalShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 64.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Hides steps between neighbouring "
                   "triangles, and "
                   "with them real contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.toggle("coverage_map", coverageMap_, false,
                   "Finds the texels that one triangle covers all through the shutter, and leaves out what lies behind "
                   "it there: shorter lists "
                   "for one more pass.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering: the test is made in (2n + 1) x (2n + 1) texels and averaged. Hides the "
                  "map's steps, costs that many lists.");
    visitor.toggle("as_published", asPublished_, false,
                   "As the paper states it: every triangle has a prism of flat triangles and one tuple a texel, depths "
                   "are as rasterised, numbers of triangles take the place of a bias, and the coverage map takes two "
                   "ends for the whole shutter.");
    visitor.number("published_bias", publishedBias_, 0.0, 0.0, 64.0, "texels",
                   "As published only, in place of bias. The paper has none; above 0, to see what that would hide, "
                   "slope_bias counts as well.");
}

Footprint TemporalShadow::footprint() const {
    Footprint footprint;
    footprint.filterTexels = Footprint::filterOf(pcfRadius_);
    return footprint;
}

SamplingTraits TemporalShadow::samplingTraits() const {
    return {.texelCentres = true, .biasTexels = static_cast<double>(asPublished_ ? publishedBias_ : bias_)};
}

std::shared_ptr<const Prediction> TemporalShadow::prediction() const {
    return asPublished_ ? std::make_shared<PublishedTuplesPrediction>() : Technique::prediction();
}

std::vector<PassDecision> TemporalShadow::passes(const FramePlan& plan) const {
    const LightMotion& motion = plan.casters;
    std::vector<PassDecision> passes;
    if (!motion.staticCasters.empty() && !asPublished_)
        passes.push_back(
            {"build/static map",
             "an ordinary map of what stands still in the light's frame, kept until something of it changes",
             motion.staticCasters.size()});
    if (coverageMap_)
        passes.push_back({"coverage", "texels that one triangle covers all through the shutter", listed(plan).size()});
    std::string reason = motion.dynamicCasters.empty() ? "nothing moves in the light's frame: no tuples"
                                                       : "when each triangle that moves in the light's frame is where";
    if (asPublished_) reason = "when each triangle is where, also those that stand still";
    if (motion.nonTranslating > 0)
        reason += asPublished_ ? fmt::format(
                                     "; {} of them turn or deform, so the sides of their prisms are bent, and flat "
                                     "triangles stand for them",
                                     motion.nonTranslating)
                               : fmt::format(
                                     "; {} of them turn or deform: times are exact, distances between them within a "
                                     "quarter of a texel as a rule",
                                     motion.nonTranslating);
    passes.push_back({"build", reason, listed(plan).size()});
    std::string lookup = "each camera sample against the tuples of its texel that hold its time";
    if (!motion.nearPlane.empty())
        lookup += asPublished_ ? fmt::format("; the prisms of {} triangles are cut open by the light's near plane",
                                             motion.nearPlane.size())
                               : fmt::format("; against {} triangles that cross the light's near plane one by one",
                                             motion.nearPlane.size());
    passes.push_back({"lookup", lookup, asPublished_ ? 0 : motion.nearPlane.size()});
    return passes;
}

void TemporalShadow::build(const TechniqueFrame& frame) {
    const LightMotion& motion = frame.plan.casters;
    staticCasters_ = asPublished_ ? 0 : motion.staticCasters.size();
    nonTranslating_ = motion.nonTranslating;
    const bool otherForm = builtAsPublished_ != asPublished_;
    builtAsPublished_ = asPublished_;
    staticMap_ = nullptr;
    if (!asPublished_) {
        const auto timed = frame.timer.scope("build/static map");
        staticMap_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Exact);
    }
    near_.set(motion.nearPlane);
    const std::vector<std::uint32_t> triangles = listed(frame.plan);
    moving_ = triangles.size();
    if (otherForm || triangles.empty()) lists_.reset();  // first, so that both forms need not fit at once
    builtWithCoverage_ = coverageMap_;
    if (!triangles.empty()) buildLists(frame, triangles);
}

std::vector<std::uint32_t> TemporalShadow::listed(const FramePlan& plan) const {
    // "We render all triangles" ("Extension"). The paper knows no near plane: such prisms are clipped and stay open.
    return asPublished_ ? allOf(plan.casters) : plan.casters.dynamicCasters;
}

void TemporalShadow::buildLists(const TechniqueFrame& frame, const std::vector<std::uint32_t>& triangles) {
    if (!lists_) {
        if (asPublished_)
            lists_ = std::make_unique<PublishedTuples>(programs_);
        else
            lists_ = std::make_unique<ExactTuples>(programs_);
    }
    lists_->build(frame, triangles, coverageMap_);
}

LookupProgram TemporalShadow::lookupProgram(const TechniqueFrame&, Casters) {
    LookupProgram lookup{"temporal lookup", "techniques/temporal/lookup.frag", {}, {}};
    if (builtAsPublished_) lookup.defines.emplace_back("AS_PUBLISHED", "1");
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    if (staticMap_) {
        lookup.defines.emplace_back("STATIC_TRIANGLES", "1");
        lookup.inputs.texture("staticMap", *staticMap_);
    }
    if (lists_) {
        lookup.defines.emplace_back("DYNAMIC_TRIANGLES", "1");
        if (builtWithCoverage_) lookup.defines.emplace_back("COVERAGE_MAP", "1");
        lists_->addInputs(lookup.inputs);
    }
    if (!builtAsPublished_ && near_.count() > 0) {
        lookup.defines.emplace_back("NEAR_TRIANGLES", "1");
        near_.addInputs(lookup.inputs);
    }
    return lookup;
}

std::vector<TechniqueView> TemporalShadow::views() const {
    return {{"tuples", "Tuples per texel", "tuples", 0.0, 64.0, false},
            {"light", "Tuples as the light sees them", "tuples", 0.0, 64.0, false},
            {"time", "When the first tuple begins", "u", 0.0, 1.0, false}};
}

void TemporalShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "tuples" && name != "light" && name != "time") return Technique::drawView(frame, name, values);
    if (!lists_) buildLists(frame, listed(frame.plan));  // empty ones, to be looked at
    gl::ShaderDefines defines = frame.defines();
    if (builtAsPublished_) defines.emplace_back("AS_PUBLISHED", "1");
    if (name == "time") defines.emplace_back("VIEW_TIME", "1");
    if (name == "light") defines.emplace_back("SEEN_BY_LIGHT", "1");
    const gl::Program& program =
        programs_.get({"temporal view", "passes/fullscreen.vert", "techniques/temporal/view.frag", defines});
    gl::Inputs inputs;
    lists_->addInputs(inputs);
    program.use(inputs);
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    viewTarget_.bind(values);
    frame.fullscreen.draw(program);
}

StoredAlongLine TemporalShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    if (staticMap_ != nullptr) addMapMarks(frame.plan, *staticMap_, line, 0.0, 1.0, stored.marks);
    if (lists_) lists_->addMarks(frame.plan, line, stored.marks);
    stored.note = "tuples: when the texel's centre is covered, and how far away";
    if (builtWithCoverage_) stored.note += "; the coverage map is not shown";
    if (near_.count() > 0) stored.note += "; triangles at the near plane are not shown";
    return stored;
}

std::vector<TechniqueStatistic> TemporalShadow::statistics() const {
    if (!lists_ && !staticMap_) return {};
    const TupleCounts counts = lists_ ? lists_->counts() : TupleCounts{};
    const auto number = [](std::size_t n) { return static_cast<double>(n); };
    std::vector<TechniqueStatistic> statistics{
        {builtAsPublished_ ? "triangles with a prism" : "dynamic triangles", number(moving_), "", ""},
        {"non-translating triangles", number(nonTranslating_), "",
         nonTranslating_ > 0 && builtAsPublished_
             ? "the sides of their prisms are bent: times are off by some thousandths"
             : ""},
        {"static triangles", number(staticCasters_), "", ""},
        {"near-plane triangles", number(near_.count()), "",
         near_.count() > 0 && builtAsPublished_
             ? "their prisms are cut open: shadows may begin or end at the wrong time"
             : ""},
        {"tuples", number(counts.tuples), "", ""},
        {"longest list", number(counts.longestList), "tuples", ""},
    };
    if (builtWithCoverage_) {
        statistics.push_back({"covered texels", number(counts.coveredTexels), "texels", ""});
        statistics.push_back({"tuples skipped", number(counts.skippedTuples), "", ""});
    }
    const std::size_t mapBytes = staticMap_ ? staticMap_->bytes() : 0;
    statistics.push_back({"memory", number(bytes() + mapBytes), "bytes", ""});
    statistics.push_back({"memory predicted",
                          number(counts.predictedBytes + mapBytes + near_.count() * sizeof(std::uint32_t)), "bytes",
                          ""});
    return statistics;
}

std::vector<const gl::Texture*> TemporalShadow::textures() const {
    return lists_ ? lists_->textures() : std::vector<const gl::Texture*>{};
}

std::size_t TemporalShadow::bytes() const { return (lists_ ? lists_->bytes() : 0) + near_.bytes(); }

TechniqueEntry temporalTechnique() { return entryOf<TemporalShadow>(); }

}  // namespace timeshade
