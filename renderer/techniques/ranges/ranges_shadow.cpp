#include "techniques/ranges/ranges_shadow.h"

#include <algorithm>

#include <fmt/format.h>

#include "technique/technique_entry.h"
#include "techniques/ranges/bindings.shared.h"
#include "techniques/ranges/contiguous_ranges.h"
#include "techniques/ranges/linked_ranges.h"
#include "techniques/ranges/published_ranges_prediction.h"

namespace timeshade {

const TechniqueDescription& RangesShadow::describe() {
    static const TechniqueDescription description{
        .name = "ranges",
        .title = "Depth-time ranges",
        .shortTitle = "Ranges",
        .summary =
            "Lists, per map texel, of when each moving triangle covers it and how far away: no noise of the map's own, "
            "memory grows with what moves.",
        .source = "Hong and Oh 2019",
        .wrong =
            "The map's resolution, though less than an ordinary map: ranges are carried on to the receiver's own "
            "place. The sides of turning triangles are bilinear, and that shape is followed only nearly.",
        .look = "pillars beside temporal, same map: finer edges.",
        .picture = "pillars: left ranges with a map of 256, right ground truth.",
        .references = {"M. Hong, K. Oh 2019: Motion-blurred shadows utilizing a depth-time ranges shadow map."},
    };
    return description;
}

void RangesShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number("bias", bias_, 0.5, 0.0, 64.0, "texels",
                   "How much nearer to the light a caster must be before it counts. Hides steps between neighbouring "
                   "triangles, and "
                   "with them real contacts.");
    visitor.number("slope_bias", slopeBias_, 1.0, 0.0, 8.0, "half texels of slope",
                   "Further bias in proportion to how steeply the surface falls away from the light.");
    visitor.whole("pcf_radius", pcfRadius_, 0, 0, 3, "texels",
                  "Percentage-closer filtering: the test is made in (2n + 1) x (2n + 1) texels and averaged. Hides the "
                  "map's steps, costs that many lists.");
    visitor.toggle("as_published", asPublished_, false,
                   "As the paper states it: every triangle has a prism, fragments in linked lists are paired by depth, "
                   "depths are as rasterised, and numbers of triangles take the place of a bias.");
    visitor.number("published_bias", publishedBias_, 0.0, 0.0, 64.0, "texels",
                   "As published only, in place of bias. The paper has none; above 0, to see what that would hide, "
                   "slope_bias counts as well.");
}

Footprint RangesShadow::footprint() const {
    Footprint footprint;
    footprint.filterTexels = Footprint::filterOf(pcfRadius_);
    return footprint;
}

SamplingTraits RangesShadow::samplingTraits() const {
    // Each side is extended across the texel on its own: another cut of a surface has other sides. A few per mille are
    // seen to change.
    return {.texelCentres = true,
            .biasTexels = static_cast<double>(asPublished_ ? publishedBias_ : bias_),
            .triangulationError = asPublished_ ? 0.0 : 0.005};
}

std::shared_ptr<const Prediction> RangesShadow::prediction() const {
    return asPublished_ ? std::make_shared<PublishedRangesPrediction>() : Technique::prediction();
}

std::vector<PassDecision> RangesShadow::passes(const FramePlan& plan) const {
    const LightMotion& motion = plan.casters;
    std::vector<PassDecision> passes;
    if (!motion.staticCasters.empty() && !asPublished_)
        passes.push_back(
            {"build/static map",
             "an ordinary map of what stands still in the light's frame, kept until something of it changes",
             motion.staticCasters.size()});
    std::string reason = motion.dynamicCasters.empty() ? "nothing moves in the light's frame: no prisms"
                                                       : "a prism for each triangle that moves in the light's frame";
    if (asPublished_) reason = "a prism for each triangle, also for those that stand still";
    if (motion.nonTranslating > 0)
        reason += fmt::format(
            "; {} of them turn or deform, so their sides are not flat and their times are off by some thousandths of "
            "the shutter",
            motion.nonTranslating);
    reason += asPublished_ ? "; fragments of one triangle are paired by depth"
                           : "; fragments of one triangle are paired by time";
    passes.push_back({"build", reason, listed(plan).dynamicCasters.size()});
    std::string lookup = "each camera sample against the ranges of its texel that hold its time";
    if (!motion.nearPlane.empty())
        lookup += asPublished_ ? fmt::format("; the prisms of {} triangles are cut open by the light's near plane",
                                             motion.nearPlane.size())
                               : fmt::format("; against {} triangles that cross the light's near plane one by one",
                                             motion.nearPlane.size());
    passes.push_back({"lookup", lookup, asPublished_ ? 0 : motion.nearPlane.size()});
    return passes;
}

LightMotion RangesShadow::listed(const FramePlan& plan) const {
    LightMotion motion = plan.casters;
    if (!asPublished_) return motion;
    // "We render all geometries" (section 4). The paper knows no near plane: such prisms are clipped and stay open.
    motion.dynamicCasters = allOf(motion);
    motion.staticCasters.clear();
    motion.nearPlane.clear();
    return motion;
}

void RangesShadow::build(const TechniqueFrame& frame) {
    const LightMotion motion = listed(frame.plan);
    staticCasters_ = motion.staticCasters.size();
    moving_ = motion.dynamicCasters.size();
    nonTranslating_ = motion.nonTranslating;
    staticMap_ = nullptr;
    if (!asPublished_) {
        const auto timed = frame.timer.scope("build/static map");
        staticMap_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Rasterized);
    }
    near_.set(motion.nearPlane);
    if (builtAsPublished_ != asPublished_ || moving_ == 0)
        lists_.reset();  // first, so that both forms need not fit at once
    builtAsPublished_ = asPublished_;
    if (moving_ > 0) buildLists(frame, motion);
}

void RangesShadow::buildLists(const TechniqueFrame& frame, const LightMotion& motion) {
    if (!lists_) {
        if (asPublished_)
            lists_ = std::make_unique<LinkedRanges>(programs_);
        else
            lists_ = std::make_unique<ContiguousRanges>(programs_);
    }
    lists_->build(frame, motion);
}

LookupProgram RangesShadow::lookupProgram(const TechniqueFrame&, Casters) {
    LookupProgram lookup{"ranges lookup", "techniques/ranges/lookup.frag", {}, {}};
    if (builtAsPublished_) lookup.defines.emplace_back("AS_PUBLISHED", "1");
    lookup.defines.emplace_back("PCF_RADIUS", fmt::format("{}", pcfRadius_));
    if (staticCasters_ > 0) lookup.defines.emplace_back("STATIC_TRIANGLES", "1");
    if (staticMap_) lookup.inputs.texture("staticMap", *staticMap_);
    if (lists_) {
        lookup.defines.emplace_back("DYNAMIC_TRIANGLES", "1");
        lists_->addInputs(lookup.inputs);
    }
    if (near_.count() > 0) {
        lookup.defines.emplace_back("NEAR_TRIANGLES", "1");
        near_.addInputs(lookup.inputs);
    }
    return lookup;
}

std::vector<TechniqueView> RangesShadow::views() const {
    return {{"ranges", "Ranges per texel", "ranges", 0.0, 64.0, false},
            {"light", "Ranges as the light sees them", "ranges", 0.0, 64.0, false},
            {"time", "When the first range begins", "u", 0.0, 1.0, false}};
}

void RangesShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "ranges" && name != "light" && name != "time") return Technique::drawView(frame, name, values);
    if (!lists_) buildLists(frame, listed(frame.plan));  // empty ones, to be looked at
    gl::ShaderDefines defines = frame.defines();
    if (builtAsPublished_) defines.emplace_back("AS_PUBLISHED", "1");
    if (name == "time") defines.emplace_back("VIEW_TIME", "1");
    if (name == "light") defines.emplace_back("SEEN_BY_LIGHT", "1");
    const gl::Program& program =
        programs_.get({"ranges view", "passes/fullscreen.vert", "techniques/ranges/view.frag", defines});
    gl::Inputs inputs;
    lists_->addInputs(inputs);
    program.use(inputs);
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    viewTarget_.bind(values);
    frame.fullscreen.draw(program);
}

StoredAlongLine RangesShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    if (staticMap_ != nullptr) addMapMarks(frame.plan, *staticMap_, line, 0.0, 1.0, stored.marks);
    if (lists_) lists_->addMarks(frame.plan, line, stored.marks);
    stored.note = "ranges: when a triangle covers the place, extended inside each texel, and how far away";
    if (near_.count() > 0) stored.note += "; triangles at the near plane are not shown";
    return stored;
}

std::vector<TechniqueStatistic> RangesShadow::statistics() const {
    if (!lists_ && !staticMap_) return {};
    const RangeCounts counts = lists_ ? lists_->counts() : RangeCounts{};
    const auto number = [](std::size_t n) { return static_cast<double>(n); };
    std::vector<TechniqueStatistic> statistics{
        {builtAsPublished_ ? "triangles with a prism" : "dynamic triangles", number(moving_), "", ""},
        {"non-translating triangles", number(nonTranslating_), "",
         nonTranslating_ > 0 ? "the sides of their prisms are not flat: times are off by some thousandths" : ""},
        {"static triangles", number(staticCasters_), "", ""},
        {"near-plane triangles", number(near_.count()), "", ""},
        {"fragments", number(counts.fragments), "", ""},
        {"ranges", number(counts.ranges), "", ""},
        {"longest list", number(counts.longestList), "fragments", ""},
        {"lists with unpaired fragments", number(counts.unpairedLists), "texels",
         counts.unpairedLists > 0 ? "prisms were not closed there: shadows may begin or end at the wrong time" : ""},
        {"memory by equation 2", number(predictedBytes(counts)), "bytes", ""},
    };
    return statistics;
}

/// The ordinary map of still triangles is no part of the paper's equation, and is added.
std::size_t RangesShadow::predictedBytes(const RangeCounts& counts) const {
    return counts.predictedBytes + (staticMap_ ? staticMap_->bytes() : 0);
}

std::size_t RangesShadow::bytes() const { return (lists_ ? lists_->bytes() : 0) + near_.bytes(); }

TechniqueEntry rangesTechnique() { return entryOf<RangesShadow>(); }

}  // namespace timeshade
