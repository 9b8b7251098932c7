#include "techniques/exact/exact_shadow.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/hash.h"
#include "technique/technique_entry.h"

namespace timeshade {

const TechniqueDescription& ExactShadow::describe() {
    static const TechniqueDescription description{
        .name = "exact",
        .title = "Exact candidates",
        .shortTitle = "Exact",
        .summary =
            "Lists the moving triangles that might shadow each part of the light's view, and tests them per camera "
            "sample at its own time: as right as ray tracing, without noise of its own, aliasing or bias.",
        .source = "this program; after Story 2015 (hybrid ray-traced shadows) and Vasilakis, Fudos 2012 (S-buffer)",
        .wrong =
            "Nothing beyond the rounding of floats. Its price is in crowds: where many moving triangles lie over one "
            "cell of the light's view, each sample tests them all.",
        .look = "cubes with a count of 2,000: the view of candidates shows where the time goes.",
        .picture = "cubes: left the picture, right how many triangles each sample tests.",
        .references = {"J. Story 2015: Hybrid ray traced shadows. Game Developers Conference.",
                       "A. Vasilakis, I. Fudos 2012: S-buffer: sparsity-aware multi-fragment rendering. Eurographics "
                       "short papers.",
                       "G. Johnson, J. Lee, C. Burns, W. Mark 2005: The irregular Z-buffer. ACM Transactions on "
                       "Graphics 24 (4)."},
    };
    return description;
}

void ExactShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("side", side_, 0, 0, 1024, "cells",
                  "Cells along a side of the grid of lists; 0 lets a cost model choose a power of two up to --map. "
                  "Changes time and "
                  "memory, never the picture.");
    visitor.whole("buckets", buckets_, 0, 0, 32, "buckets",
                  "Pieces of the shutter with lists of their own; 0 lets a cost model choose. Fast casters want more. "
                  "Changes time and "
                  "memory, never the picture.");
    visitor.toggle("list_all", listAll_, false,
                   "Also lists casters that change nothing: triangles of closed surfaces that face away from the "
                   "light, and those that no receiver is behind. Changes time and memory, never the picture.");
}

ExactShadow::FrameCasters ExactShadow::castersOf(const FramePlan& plan) const {
    std::optional<CasterCulling> culling;
    if (!listAll_ && !plan.request.forceDynamic) culling.emplace(plan, surfaces_.of(plan));
    return {sorted(culling, plan.casters.dynamicCasters, plan.casters.nearPlane),
            sorted(culling, plan.casters.staticCasters, {})};
}

ExactShadow::CasterList ExactShadow::sorted(const std::optional<CasterCulling>& culling,
                                            const std::vector<std::uint32_t>& ids,
                                            const std::vector<std::uint32_t>& more) {
    CasterList casters;
    for (const auto* list : {&ids, &more}) {
        for (const std::uint32_t id : *list) {
            switch (culling ? culling->of(id) : CasterCulling::Reason::None) {
            case CasterCulling::Reason::FacingAway: ++casters.facingAway; break;
            case CasterCulling::Reason::NoReceiverBehind: ++casters.noReceiverBehind; break;
            case CasterCulling::Reason::None: casters.listed.push_back(id); break;
            }
        }
    }
    return casters;
}

CandidateGridSize ExactShadow::wantedFor(const FramePlan& plan, const std::vector<std::uint32_t>& casters,
                                         bool moving) const {
    return chooseCandidateGrid(plan, casters, moving, side_, buckets_);
}

std::vector<PassDecision> ExactShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes;
    const auto add = [&](const char* name, const char* which, const CandidateGridSize& size, std::size_t triangles) {
        passes.push_back(
            {name,
             fmt::format("lists of {} x {} cells{} and {} bucket{} of time, for what {} in the light's frame; about "
                         "{:.3g} entries, "
                         "{:.2g} candidates a sample expected",
                         size.side, size.side, side_ > 0 ? "" : " (chosen)", size.buckets, size.buckets == 1 ? "" : "s",
                         which, size.expectedEntries, size.expectedCandidates),
             triangles});
    };
    const auto [dynamicCasters, staticCasters] = castersOf(plan);
    if (!staticCasters.listed.empty())
        add("build/static", "stands still", wantedFor(plan, staticCasters.listed, false), staticCasters.listed.size());
    if (!dynamicCasters.listed.empty())
        add("build/dynamic", "moves", wantedFor(plan, dynamicCasters.listed, true), dynamicCasters.listed.size());
    std::string lookup =
        "each camera sample against the triangles of its own cell and bucket, at its own time and place";
    if (const std::size_t away = dynamicCasters.facingAway + staticCasters.facingAway; away > 0)
        lookup += fmt::format("; {} are culled: back faces of closed surfaces, seen from the light", away);
    if (const std::size_t behind = dynamicCasters.noReceiverBehind + staticCasters.noReceiverBehind; behind > 0)
        lookup += fmt::format("; {} are culled: no receiver behind", behind);
    passes.push_back({"lookup", lookup, 0});
    return passes;
}

void ExactShadow::build(const TechniqueFrame& frame) {
    FrameCasters casters = castersOf(frame.plan);
    staticCasters_ = std::move(casters.staticOnes);
    dynamicCasters_ = std::move(casters.dynamicOnes);
    buildStatic(frame);
    buildDynamic(frame);
}

void ExactShadow::buildStatic(const TechniqueFrame& frame) {
    static_ = nullptr;
    if (staticCasters_.listed.empty()) return;
    const FramePlan& plan = frame.plan;
    // Which surfaces may be culled may depend on the camera, of which the version of the casters says nothing.
    CacheKey key = 0;
    if (plan.versions.casters != 0)
        key =
            Hash().add(plan.versions.casters).add(static_cast<std::uint64_t>(side_)).add(staticCasters_.listed).value();
    auto& entry = frame.caches.entry<StaticLists>("exact: static lists");
    const bool held = entry.holds(key);
    StaticLists& lists = entry.get(programs_);
    static_ = &lists;
    if (held) return;
    const auto timed = frame.timer.scope("build/static");
    lists.travel = std::any_of(staticCasters_.listed.begin(), staticCasters_.listed.end(),
                               [&](std::uint32_t id) { return (*plan.triangles)[id].movesInWorld; });
    lists.wanted = wantedFor(plan, staticCasters_.listed, false);
    lists.grid.build(plan, staticCasters_.listed, lists.wanted);
    entry.setKey(key);
}

void ExactShadow::buildDynamic(const TechniqueFrame& frame) {
    if (dynamicCasters_.listed.empty()) {
        dynamic_.reset();
        return;
    }
    const auto timed = frame.timer.scope("build/dynamic");
    wantedDynamic_ = wantedFor(frame.plan, dynamicCasters_.listed, true);
    if (!dynamic_) dynamic_.emplace(programs_);
    dynamic_->build(frame.plan, dynamicCasters_.listed, wantedDynamic_);
}

LookupProgram ExactShadow::lookupProgram(const TechniqueFrame&, Casters) {
    LookupProgram lookup{"exact lookup", "techniques/exact/lookup.frag", {}, {}};
    if (dynamic_) {
        lookup.defines.emplace_back("DYNAMIC_TRIANGLES", "1");
        lookup.inputs.set("dynamicSide", static_cast<std::uint32_t>(dynamic_->side()))
            .set("buckets", static_cast<std::uint32_t>(dynamic_->buckets()))
            .texture("dynamicOffsets", dynamic_->offsets())
            .texture("dynamicCandidates", dynamic_->candidates());
    }
    if (static_ != nullptr) {
        lookup.defines.emplace_back("STATIC_TRIANGLES", "1");
        if (static_->travel) lookup.defines.emplace_back("STATIC_CASTERS_TRAVEL", "1");
        lookup.inputs.set("staticSide", static_cast<std::uint32_t>(static_->grid.side()))
            .texture("staticOffsets", static_->grid.offsets())
            .texture("staticCandidates", static_->grid.candidates());
    }
    return lookup;
}

std::vector<TechniqueView> ExactShadow::views() const {
    return {{"candidates", "Candidates tested per camera sample", "triangles", 0.0, 32.0, false}};
}

void ExactShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "candidates") return Technique::drawView(frame, name, values);
    const LookupProgram lookup = lookupProgram(frame, Casters::All);
    gl::ShaderDefines defines = frame.defines();
    defines.emplace_back("VIEW_CANDIDATES", "1");
    defines.insert(defines.end(), lookup.defines.begin(), lookup.defines.end());
    const gl::Program& program =
        programs_.get({"exact view", "passes/fullscreen.vert", lookup.fragment, std::move(defines)});
    program.use(lookup.inputs);
    program.set("share", 1.0f / static_cast<float>(frame.plan.block.strata));
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    const gl::Framebuffer& target = viewTarget_.bind(values);
    const std::array<GLfloat, 4> zero{};
    glClearNamedFramebufferfv(target.name(), GL_COLOR, 0, zero.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        program.set("stratum", stratum);
        frame.fullscreen.draw(program);
    }
    glDisable(GL_BLEND);
}

StoredAlongLine ExactShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    if (static_ != nullptr) static_->grid.addMarks(frame.plan, line, stored.marks);
    if (dynamic_) dynamic_->addMarks(frame.plan, line, stored.marks);
    stored.note =
        "candidates: what may lie there during a bucket of the shutter, no nearer than so; each is tested exactly";
    return stored;
}

std::vector<TechniqueStatistic> ExactShadow::statistics() const {
    std::vector<TechniqueStatistic> statistics{
        {"dynamic triangles", static_cast<double>(dynamicCasters_.count()), "", ""},
        {"static triangles", static_cast<double>(staticCasters_.count()), "", ""},
        {"culled: facing away", static_cast<double>(dynamicCasters_.facingAway + staticCasters_.facingAway), "", ""},
        {"culled: no receiver behind",
         static_cast<double>(dynamicCasters_.noReceiverBehind + staticCasters_.noReceiverBehind), "", ""}};
    const auto add = [&](const std::string& which, const CandidateGrid& grid, const CandidateGridSize& wanted,
                         std::size_t casters) {
        const auto entries = static_cast<double>(grid.entries());
        statistics.push_back({which + "grid side", static_cast<double>(grid.side()), "cells",
                              grid.coarsened() ? "the lists outgrew this device's storage blocks; the grid was made "
                                                 "coarser, which costs time and no accuracy"
                                               : ""});
        statistics.push_back({which + "entries", entries, "", ""});
        statistics.push_back({which + "entries expected", wanted.expectedEntries, "", ""});
        statistics.push_back({which + "entries per triangle", entries / static_cast<double>(casters), "", ""});
        statistics.push_back(
            {which + "memory per triangle", grid.entryBytes() / static_cast<double>(casters), "bytes", ""});
        statistics.push_back({which + "memory of the cells", grid.cellBytes() / (1024.0 * 1024.0), "MiB", ""});
    };
    if (dynamic_) {
        statistics.push_back({"buckets", static_cast<double>(dynamic_->buckets()), "", ""});
        add("", *dynamic_, wantedDynamic_, dynamicCasters_.count());
    }
    if (static_ != nullptr) add("static ", static_->grid, static_->wanted, staticCasters_.count());
    return statistics;
}

TechniqueEntry exactTechnique() { return entryOf<ExactShadow>(); }

}  // namespace timeshade
