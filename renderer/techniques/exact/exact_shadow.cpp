#include "techniques/exact/exact_shadow.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace timeshade {

const TechniqueDescription& ExactShadow::describe() {
    static const TechniqueDescription description{
        "exact", "Exact candidates",
        "Lists the moving triangles that might shadow each part of the light's view, and tests them per camera sample at its own time: as right "
        "as ray tracing, without noise of its own, aliasing or bias.",
        "this program; after Story 2015 (hybrid ray-traced shadows) and Vasilakis, Fudos 2012 (S-buffer)"};
    return description;
}

void ExactShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("side", side_, 0, 0, 1024, "cells",
                  "Cells along a side of the grid of lists; 0 lets a cost model choose a power of two up to --map. Changes time and "
                  "memory, never the picture.");
    visitor.whole("buckets", buckets_, 0, 0, 32, "buckets",
                  "Pieces of the shutter with lists of their own; 0 lets a cost model choose. Fast casters want more. Changes time and "
                  "memory, never the picture.");
}

namespace {

std::vector<std::uint32_t> movingCasters(const FramePlan& plan) {
    std::vector<std::uint32_t> all = plan.casters.moving;
    all.insert(all.end(), plan.casters.nearPlane.begin(), plan.casters.nearPlane.end());
    return all;
}

} // namespace

CandidateGridSize ExactShadow::wantedFor(const FramePlan& plan, bool moving) const {
    return chooseCandidateGrid(plan, moving ? movingCasters(plan) : plan.casters.still, moving, side_, buckets_);
}

std::vector<PassDecision> ExactShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes;
    const auto add = [&](const char* name, const char* which, const CandidateGridSize& size, std::size_t triangles) {
        passes.push_back({name,
                          fmt::format("lists of {} x {} cells{} and {} bucket{} of time, for what {} in the light's frame; about {:.3g} entries, "
                                      "{:.2g} candidates a sample expected",
                                      size.side, size.side, side_ > 0 ? "" : " (chosen)", size.buckets, size.buckets == 1 ? "" : "s", which,
                                      size.expectedEntries, size.expectedCandidates),
                          triangles});
    };
    if (!plan.casters.still.empty()) add("build/still", "stands still", wantedFor(plan, false), plan.casters.still.size());
    if (!plan.casters.nothingMoves()) add("build/moving", "moves", wantedFor(plan, true), plan.casters.moving.size() + plan.casters.nearPlane.size());
    passes.push_back({"lookup", "each camera sample against the triangles of its own cell and bucket, at its own time and place", 0});
    return passes;
}

void ExactShadow::build(const TechniqueFrame& frame) {
    const FramePlan& plan = frame.plan;
    const std::vector<std::uint32_t> movers = movingCasters(plan);
    movingCasters_ = movers.size();
    stillCasters_ = plan.casters.still.size();
    stillCastersTravel_ = std::any_of(plan.casters.still.begin(), plan.casters.still.end(), [&](std::uint32_t id) { return (*plan.triangles)[id].movesInWorld; });
    const bool kept = still_ && plan.still.casters != 0 && plan.still.casters == stillVersion_ && side_ == stillSide_;
    if (stillCasters_ == 0) {
        still_.reset();
    } else if (!kept) {
        const auto timed = frame.timer.scope("build/still");
        wantedStill_ = wantedFor(plan, false);
        if (!still_) still_.emplace(programs_);
        still_->build(plan, plan.casters.still, wantedStill_);
    }
    stillVersion_ = plan.still.casters;
    stillSide_ = side_;
    if (movers.empty()) {
        moving_.reset();
        return;
    }
    const auto timed = frame.timer.scope("build/moving");
    wantedMoving_ = wantedFor(plan, true);
    if (!moving_) moving_.emplace(programs_);
    moving_->build(plan, movers, wantedMoving_);
}

const gl::Program& ExactShadow::lookupProgram(const TechniqueFrame& frame, gl::ShaderDefines defines) {
    for (const auto& define : viewDefines(frame.plan)) defines.push_back(define);
    if (moving_) defines.emplace_back("MOVING_TRIANGLES", "1");
    if (still_) defines.emplace_back("STILL_TRIANGLES", "1");
    if (still_ && stillCastersTravel_) defines.emplace_back("STILL_CASTERS_TRAVEL", "1");
    const gl::Program& program = programs_.get({"exact lookup", "passes/fullscreen.vert", "techniques/exact/lookup.frag", defines});
    program.use();
    if (moving_) {
        glUniform1ui(1, static_cast<GLuint>(moving_->side()));
        glUniform1ui(2, static_cast<GLuint>(moving_->buckets()));
        moving_->bindForLookup(TECHNIQUE_UNIT);
    }
    if (still_) {
        glUniform1ui(3, static_cast<GLuint>(still_->side()));
        still_->bindForLookup(TECHNIQUE_UNIT + 2);
    }
    return program;
}

void ExactShadow::lookup(const TechniqueFrame& frame) {
    frame.lookup.draw(frame, [&](const gl::ShaderDefines& purpose) -> const gl::Program& { return lookupProgram(frame, purpose); });
}

std::vector<TechniqueView> ExactShadow::views() const {
    return {{"candidates", "Candidates tested per camera sample", "triangles", 0.0, 32.0, false}};
}

void ExactShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "candidates") return Technique::drawView(frame, name, values);
    const gl::Program& program = lookupProgram(frame, {{"VIEW_CANDIDATES", "1"}});
    glUniform1f(4, 1.0f / static_cast<float>(frame.plan.block.strata));
    frame.samples.ids().bind(SAMPLE_IDS_UNIT);
    if (!viewTarget_) viewTarget_.emplace("candidates view target");
    viewTarget_->setColorCount(1);
    viewTarget_->attach(GL_COLOR_ATTACHMENT0, values);
    viewTarget_->bindForDrawing(values.width(), values.height());
    const std::array<GLfloat, 4> zero{};
    glClearNamedFramebufferfv(viewTarget_->name(), GL_COLOR, 0, zero.data());
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE);
    for (std::uint32_t stratum = 0; stratum < frame.plan.block.strata; ++stratum) {
        glUniform1ui(0, stratum);
        frame.fullscreen.draw(program);
    }
    glDisable(GL_BLEND);
}

std::vector<TechniqueFigure> ExactShadow::figures() const {
    std::vector<TechniqueFigure> figures{{"moving triangles", static_cast<double>(movingCasters_), "", ""},
                                         {"still triangles", static_cast<double>(stillCasters_), "", ""}};
    const auto add = [&](const std::string& which, const CandidateGrid& grid, const CandidateGridSize& wanted, std::size_t casters) {
        const auto entries = static_cast<double>(grid.entries());
        figures.push_back({which + "grid side", static_cast<double>(grid.side()), "cells",
                           grid.coarsened() ? "the lists outgrew this device's storage blocks; the grid was made coarser, which costs time and no accuracy"
                                            : ""});
        figures.push_back({which + "entries", entries, "", ""});
        figures.push_back({which + "entries expected", wanted.expectedEntries, "", ""});
        figures.push_back({which + "entries per triangle", entries / static_cast<double>(casters), "", ""});
        figures.push_back({which + "memory per triangle", grid.entryBytes() / static_cast<double>(casters), "bytes", ""});
        figures.push_back({which + "memory of the cells", grid.cellBytes() / (1024.0 * 1024.0), "MiB", ""});
    };
    if (moving_) {
        figures.push_back({"buckets", static_cast<double>(moving_->buckets()), "", ""});
        add("", *moving_, wantedMoving_, movingCasters_);
    }
    if (still_) add("still ", *still_, wantedStill_, stillCasters_);
    return figures;
}

} // namespace timeshade
