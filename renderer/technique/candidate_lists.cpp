#include "technique/candidate_lists.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/hash.h"
#include "technique/candidate_marks.h"

namespace timeshade {

void CandidateLists::visitSettings(SettingsVisitor& visitor) {
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

CandidateLists::FrameCasters CandidateLists::castersOf(const FramePlan& plan) const {
    std::optional<CasterCulling> culling;
    if (!listAll_ && !plan.request.forceDynamic) culling.emplace(plan, surfaces_.of(plan));
    return {sorted(culling, plan.casters.dynamicCasters, plan.casters.nearPlane),
            sorted(culling, plan.casters.staticCasters, {})};
}

CandidateLists::CasterList CandidateLists::sorted(const std::optional<CasterCulling>& culling,
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

CandidateGridSize CandidateLists::wantedFor(const FramePlan& plan, const std::vector<std::uint32_t>& casters,
                                            bool moving) const {
    return chooseCandidateGrid(plan, casters, moving, side_, buckets_);
}

std::vector<PassDecision> CandidateLists::passes(const FramePlan& plan) const {
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
    return passes;
}

std::string CandidateLists::culledOf(const FramePlan& plan) const {
    const auto [dynamicCasters, staticCasters] = castersOf(plan);
    std::string culled;
    if (const std::size_t away = dynamicCasters.facingAway + staticCasters.facingAway; away > 0)
        culled += fmt::format("; {} are culled: back faces of closed surfaces, seen from the light", away);
    if (const std::size_t behind = dynamicCasters.noReceiverBehind + staticCasters.noReceiverBehind; behind > 0)
        culled += fmt::format("; {} are culled: no receiver behind", behind);
    return culled;
}

void CandidateLists::build(const TechniqueFrame& frame) {
    FrameCasters casters = castersOf(frame.plan);
    staticCasters_ = std::move(casters.staticOnes);
    dynamicCasters_ = std::move(casters.dynamicOnes);
    buildStatic(frame);
    buildDynamic(frame);
}

void CandidateLists::buildStatic(const TechniqueFrame& frame) {
    static_ = nullptr;
    if (staticCasters_.listed.empty()) return;
    const FramePlan& plan = frame.plan;
    // Which surfaces may be culled may depend on the camera, of which the version of the casters says nothing.
    CacheKey key = 0;
    if (plan.versions.casters != 0)
        key =
            Hash().add(plan.versions.casters).add(static_cast<std::uint64_t>(side_)).add(staticCasters_.listed).value();
    auto& entry = frame.caches.entry<StaticLists>("candidates: static lists");
    const bool held = entry.holds(key);
    StaticLists& lists = entry.get(programs_);
    static_ = &lists;
    if (held) return;
    const auto timed = frame.timer.scope("build/static");
    lists.travel = std::any_of(staticCasters_.listed.begin(), staticCasters_.listed.end(),
                               [&](std::uint32_t id) { return (*plan.triangles)[id].movesInWorld; });
    lists.wanted = wantedFor(plan, staticCasters_.listed, false);
    // What is kept has to be right at once.
    gl::LateCounts atOnce;
    lists.grid.build(plan, staticCasters_.listed, lists.wanted, key != 0 ? atOnce : frame.counts);
    entry.setKey(key);
}

void CandidateLists::buildDynamic(const TechniqueFrame& frame) {
    if (dynamicCasters_.listed.empty()) {
        dynamic_.reset();
        return;
    }
    const auto timed = frame.timer.scope("build/dynamic");
    wantedDynamic_ = wantedFor(frame.plan, dynamicCasters_.listed, true);
    if (!dynamic_) dynamic_.emplace(programs_);
    dynamic_->build(frame.plan, dynamicCasters_.listed, wantedDynamic_, frame.counts);
}

void CandidateLists::addTo(LookupProgram& lookup) const {
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
}

void CandidateLists::addMarks(const TechniqueFrame& frame, const MapLine& line, std::vector<StoredMark>& marks) const {
    if (static_ != nullptr) addCandidateMarks(frame.plan, static_->grid, line, marks);
    if (dynamic_) addCandidateMarks(frame.plan, *dynamic_, line, marks);
}

std::vector<TechniqueStatistic> CandidateLists::statistics() const {
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

}  // namespace timeshade
