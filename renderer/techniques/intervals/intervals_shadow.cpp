#include "techniques/intervals/intervals_shadow.h"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "plan/light_motion.h"
#include "technique/technique_entry.h"
#include "techniques/intervals/intervals_prediction.h"

namespace timeshade {

namespace {

constexpr std::uint32_t capacities[] = {8, 16, 32, 0};

}  // namespace

const TechniqueDescription& IntervalsShadow::describe() {
    static const TechniqueDescription description{
        .name = "intervals",
        .title = "Interval shadow maps",
        .shortTitle = "Intervals",
        .summary =
            "Lists, per map texel, of the intervals during which the light sees a triangle there: exact in time, and "
            "short, as what is hidden is left out.",
        .source = "Palmér 2011, after Gribel, Doggett and Akenine-Möller 2010",
        .wrong = "Space, not time: a texel answers for its centre, so that edges follow the map's grid.",
        .look = "cubes, as published with a capacity of 8: its view of errors shows where intervals were merged.",
        .picture = "pillars, left as published with 8 intervals a texel and a bias of 1, right ground truth.",
        .references = {"J. Palmér 2011: Analytical Motion Blurred Shadows. Master's thesis, Lund University.",
                       "C. J. Gribel, M. Doggett, T. Akenine-Möller 2010: Analytical motion blur rasterization with "
                       "compression. High-Performance Graphics."},
    };
    return description;
}

void IntervalsShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.number(
        "bias", bias_, 0.5, 0.0, 64.0, "texels",
        "How much nearer to the light than the receiver's plane at the texel's centre a caster must be before "
        "it counts. Hides steps between neighbouring triangles, and with them real contacts.");
    visitor.number("depth_error", depthError_, 0.125, 0.001, 16.0, "texels",
                   "How far a distance may be off between an interval's ends: one of a triangle that turns is halved "
                   "until it is within this.");
    visitor.toggle("visible_only", visibleOnly_, true,
                   "Leaves out of each list what the light does not see. Changes no shadow; shorter lists for a longer "
                   "build.");
    visitor.toggle("bilinear", bilinear_, false,
                   "Percentage-closer filtering: four texels are tested and weighted by how near they are. Hides the "
                   "map's steps, costs four lists.");
    visitor.toggle("as_published", asPublished_, false,
                   "As the thesis states it: intervals for all triangles, also those that stand still, linear from end "
                   "to end; lists of a limited capacity; triangle numbers and a bias against self-shadow.");
    visitor.choice("capacity", capacity_, 0, {"8", "16", "32", "none"},
                   "As published only: how many intervals a texel holds. Where there are more, the two neighbours are "
                   "merged whose distance that changes least.");
    visitor.whole("depth_pieces", depthPieces_, 1, 1, 16, "parts",
                  "As published only: into how many intervals of equal length one of a triangle that turns is cut.");
    visitor.number("published_bias", publishedBias_, 4.0, 0.0, 64.0, "texels",
                   "As published only, in place of bias. The thesis has one and gives no value.");
    visitor.whole("points_per_texel", pointsPerTexel_, 2, 1, 16, "points",
                  "As published, on interval samples: at how many points per texel of its way a receiver that moves on "
                  "the map is tested.");
    visitor.whole("least_points", leastPoints_, 5, 1, 256, "points", "The same: at how many points at least.");
}

Footprint IntervalsShadow::footprint() const {
    Footprint footprint;
    footprint.filterTexels = bilinear_ ? 2.0 : 0.0;
    return footprint;
}

SamplingTraits IntervalsShadow::samplingTraits() const {
    return {.texelCentres = true, .biasTexels = static_cast<double>(biasTexels())};
}

std::shared_ptr<const Prediction> IntervalsShadow::prediction() const {
    const auto bias = static_cast<double>(biasTexels());
    if (asPublished_) return std::make_shared<PublishedIntervalsPrediction>(bilinear_, bias, depthPieces_);
    return std::make_shared<PlaneIntervalsPrediction>(bilinear_, bias);
}

std::uint32_t IntervalsShadow::capacity() const { return capacities[capacity_]; }

std::vector<std::uint32_t> IntervalsShadow::listed(const FramePlan& plan) const {
    const LightMotion& motion = plan.casters;
    if (!asPublished_) return motion.dynamicCasters;
    std::vector<std::uint32_t> all;
    std::merge(motion.staticCasters.begin(), motion.staticCasters.end(), motion.dynamicCasters.begin(),
               motion.dynamicCasters.end(), std::back_inserter(all));
    return all;
}

std::vector<std::string> IntervalsShadow::warnings(const FramePlan& plan) const {
    if (!asPublished_ || capacity() == 0 || !plan.cutouts) return {};
    return {
        "intervals that are merged know no triangle: what alpha cuts out of one is shadowed where they stand for it"};
}

std::vector<PassDecision> IntervalsShadow::passes(const FramePlan& plan) const {
    const LightMotion& motion = plan.casters;
    std::vector<PassDecision> passes;
    if (!motion.staticCasters.empty() && !asPublished_)
        passes.push_back(
            {"build/static map",
             "an ordinary map of what stands still in the light's frame, kept until something of it changes",
             motion.staticCasters.size()});
    std::string reason = motion.dynamicCasters.empty() ? "nothing moves in the light's frame: no intervals"
                                                       : "when each triangle that moves in the light's frame is where";
    if (asPublished_) reason = "when each triangle is where, also those that stand still";
    if (motion.nonTranslating > 0)
        reason += asPublished_ ? fmt::format("; {} of them turn or deform: distances of {} interval{} stand for theirs",
                                             motion.nonTranslating, depthPieces_, depthPieces_ == 1 ? "" : "s")
                               : fmt::format("; {} of them turn or deform: distances are within {} of a texel",
                                             motion.nonTranslating, depthError_);
    passes.push_back({"build/intervals", reason, listed(plan).size()});
    if (asPublished_)
        passes.push_back({"build/arrange",
                          capacity() > 0 ? fmt::format("lists are compressed to {} intervals", capacity())
                                         : "lists are sorted, and as long as they are",
                          0});
    else if (visibleOnly_ && !motion.dynamicCasters.empty())
        passes.push_back({"build/arrange", "what the light does not see is left out of the lists", 0});
    std::string lookup = "each camera sample against the intervals of its texel that hold its time";
    if (plan.request.samples == CameraSamples::Intervals)
        lookup = asPublished_ ? fmt::format(
                                    "each segment against the intervals of its texel; one that crosses texels "
                                    "at {} points per texel, at least {}",
                                    pointsPerTexel_, leastPoints_)
                              : "each segment, texel by texel, against the intervals there";
    if (!motion.nearPlane.empty())
        lookup +=
            fmt::format("; against {} triangles that cross the light's near plane one by one", motion.nearPlane.size());
    passes.push_back({"lookup", lookup, motion.nearPlane.size()});
    return passes;
}

void IntervalsShadow::build(const TechniqueFrame& frame) {
    builtAsPublished_ = asPublished_;
    mapTexels_ = static_cast<double>(frame.plan.request.mapSize.texels());
    staticMap_ = nullptr;
    if (!asPublished_) {
        const auto timed = frame.timer.scope("build/static map");
        staticMap_ = &frame.maps.ofStaticCasters(LightMaps::Coverage::Exact);
    }
    near_.set(frame.plan.casters.nearPlane);
    const std::vector<std::uint32_t> triangles = listed(frame.plan);
    listed_ = triangles.size();
    if (triangles.empty())
        map_.reset();
    else
        buildMap(frame, triangles);
}

void IntervalsShadow::buildMap(const TechniqueFrame& frame, const std::vector<std::uint32_t>& triangles) {
    if (!map_) map_.emplace(programs_);
    map_->build(frame, triangles, {builtAsPublished_, capacity(), staticMap_});
}

LookupProgram IntervalsShadow::lookupProgram(const TechniqueFrame&, Casters) {
    LookupProgram lookup{"intervals lookup", "techniques/intervals/lookup.frag", {}, {}};
    if (builtAsPublished_) lookup.defines.emplace_back("AS_PUBLISHED", "1");
    if (bilinear_) lookup.defines.emplace_back("BILINEAR", "1");
    if (staticMap_) {
        lookup.defines.emplace_back("STATIC_TRIANGLES", "1");
        lookup.inputs.texture("staticMap", *staticMap_);
    }
    if (map_) {
        lookup.defines.emplace_back("DYNAMIC_TRIANGLES", "1");
        map_->addInputs(lookup.inputs);
    }
    if (near_.count() > 0) {
        lookup.defines.emplace_back("NEAR_TRIANGLES", "1");
        near_.addInputs(lookup.inputs);
    }
    return lookup;
}

std::vector<TechniqueView> IntervalsShadow::views() const {
    std::vector<TechniqueView> views{{"intervals", "Intervals per texel", "intervals", 0.0, 32.0, false},
                                     {"light", "Intervals as the light sees them", "intervals", 0.0, 32.0, false},
                                     {"time", "When the first interval begins", "u", 0.0, 1.0, false}};
    if (asPublished_)
        views.push_back(
            {"compression", "Error of compression, mean over the shutter", "world units", 1e-3, 10.0, true});
    return views;
}

void IntervalsShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    const bool error = name == "compression" && builtAsPublished_;
    if (name != "intervals" && name != "light" && name != "time" && !error)
        return Technique::drawView(frame, name, values);
    if (!map_) buildMap(frame, listed(frame.plan));  // empty lists, to be looked at
    gl::ShaderDefines defines = frame.defines();
    if (error) defines.emplace_back("VIEW_ERROR", "1");
    if (name == "time") defines.emplace_back("VIEW_TIME", "1");
    if (name == "light") defines.emplace_back("SEEN_BY_LIGHT", "1");
    const gl::Program& program =
        programs_.get({"intervals view", "passes/fullscreen.vert", "techniques/intervals/view.frag", defines});
    gl::Inputs inputs;
    map_->addInputs(inputs);
    if (error) inputs.texture("intervalErrors", map_->errors());
    program.use(inputs);
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    viewTarget_.bind(values);
    frame.fullscreen.draw(program);
}

StoredAlongLine IntervalsShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    if (staticMap_ != nullptr) addMapMarks(frame.plan, *staticMap_, line, 0.0, 1.0, stored.marks);
    if (map_) map_->addMarks(frame.plan, line, stored.marks);
    stored.note = "intervals: when a triangle covers the texel's centre, and how far away";
    if (!builtAsPublished_ && visibleOnly_) stored.note += ", where the light sees it";
    if (near_.count() > 0) stored.note += "; triangles at the near plane are not shown";
    return stored;
}

std::vector<TechniqueStatistic> IntervalsShadow::statistics() const {
    if (!map_ && !staticMap_) return {};
    const IntervalCounts counts = map_ ? map_->counts() : IntervalCounts{};
    const auto number = [](std::size_t n) { return static_cast<double>(n); };
    std::vector<TechniqueStatistic> statistics{
        {builtAsPublished_ ? "triangles" : "dynamic triangles", number(listed_), "", ""},
        {"near-plane triangles", number(near_.count()), "", ""},
        {"intervals collected", number(counts.collected), "", ""},
        {"intervals", number(counts.kept), "", ""},
        {"intervals per texel", number(counts.kept) / mapTexels_, "", ""},
        {"intervals per texel in use", counts.texelsInUse > 0 ? number(counts.kept) / number(counts.texelsInUse) : 0.0,
         "", ""},
        {"most intervals", number(counts.most), "", ""},
    };
    if (builtAsPublished_)
        addErrors(counts, statistics);
    else
        statistics.push_back({"bent intervals", number(counts.bentParts), "",
                              counts.bentParts > 0 ? "their distances are further off than depth_error" : ""});
    const std::size_t mapBytes = staticMap_ ? staticMap_->bytes() : 0;
    statistics.push_back({"memory", number(bytes() + mapBytes), "bytes", ""});
    statistics.push_back({"memory per texel", number(bytes() + mapBytes) / mapTexels_, "bytes", ""});
    statistics.push_back(
        {"memory predicted", number(counts.usedBytes + mapBytes + near_.count() * sizeof(std::uint32_t)), "bytes", ""});
    return statistics;
}

void IntervalsShadow::addErrors(const IntervalCounts& counts, std::vector<TechniqueStatistic>& statistics) const {
    statistics.push_back({"overflowed texels", static_cast<double>(counts.overflowed), "texels",
                          counts.overflowed > 0 ? "intervals were merged there: casters are at other distances" : ""});
    statistics.push_back({"compression error", counts.meanError, "world units", ""});
    statistics.push_back({"most compression error", counts.mostError, "world units", ""});
}

std::size_t IntervalsShadow::bytes() const { return (map_ ? map_->bytes() : 0) + near_.bytes(); }

TechniqueEntry intervalsTechnique() { return entryOf<IntervalsShadow>(); }

}  // namespace timeshade
