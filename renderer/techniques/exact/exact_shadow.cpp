#include "techniques/exact/exact_shadow.h"

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

std::vector<PassDecision> ExactShadow::passes(const FramePlan& plan) const {
    const LightMotion motion = classifyForLight(plan);
    const CandidateGridSize size = chooseCandidateGrid(plan, motion, side_, buckets_);
    const std::size_t moving = motion.moving.size() + motion.nearPlane.size();
    return {{"build",
             fmt::format("lists of {} x {} cells{}: {} triangles move in the light's view and are listed in {} buckets of time, {} stand still "
                         "and are listed once; about {:.3g} entries, {:.2g} candidates a sample expected",
                         size.side, size.side, side_ > 0 ? "" : " (chosen)", moving, size.buckets, motion.still.size(), size.expectedEntries,
                         size.expectedCandidates),
             moving + motion.still.size()},
            {"lookup", "each camera sample against the triangles of its own cell and bucket, at its own time and place", 0}};
}

void ExactShadow::build(const TechniqueFrame& frame) {
    {
        const auto timed = frame.timer.scope("build/plan");
        motion_ = classifyForLight(frame.plan);
        wanted_ = chooseCandidateGrid(frame.plan, motion_, side_, buckets_);
    }
    const auto timed = frame.timer.scope("build/lists");
    if (!grid_) grid_.emplace(programs_);
    grid_->build(frame.plan, motion_, wanted_);
}

const gl::Program& ExactShadow::lookupProgram(const TechniqueFrame& frame, bool viewCandidates) {
    gl::ShaderDefines defines = viewDefines(frame.plan);
    if (viewCandidates) defines.emplace_back("VIEW_CANDIDATES", "1");
    const gl::Program& program = programs_.get({"exact lookup", "passes/fullscreen.vert", "techniques/exact/lookup.frag", defines});
    program.use();
    glUniform1ui(1, static_cast<GLuint>(grid_->side()));
    glUniform1ui(2, static_cast<GLuint>(grid_->buckets()));
    grid_->bindForLookup(TECHNIQUE_UNIT);
    return program;
}

void ExactShadow::lookup(const TechniqueFrame& frame) {
    const gl::Program& program = lookupProgram(frame, false);
    if (!lookupPass_) lookupPass_.emplace();
    lookupPass_->draw(frame, program);
}

std::vector<TechniqueView> ExactShadow::views() const {
    return {{"candidates", "Candidates tested per camera sample", "triangles", 0.0, 32.0, false}};
}

void ExactShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "candidates") return Technique::drawView(frame, name, values);
    const gl::Program& program = lookupProgram(frame, true);
    glUniform1f(3, 1.0f / static_cast<float>(frame.plan.block.strata));
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
    if (!grid_) return {};
    const auto moving = static_cast<double>(motion_.moving.size() + motion_.nearPlane.size());
    const auto entries = static_cast<double>(grid_->entries());
    return {{"moving triangles", moving, "", ""},
            {"still triangles", static_cast<double>(motion_.still.size()), "", ""},
            {"grid side", static_cast<double>(grid_->side()), "cells",
             grid_->coarsened() ? "the lists outgrew this device's storage blocks; the grid was made coarser, which costs time and no accuracy" : ""},
            {"buckets", static_cast<double>(grid_->buckets()), "", ""},
            {"entries", entries, "", ""},
            {"entries expected", wanted_.expectedEntries, "", ""},
            {"entries per triangle", entries / std::max(1.0, moving + static_cast<double>(motion_.still.size())), "", ""}};
}

} // namespace timeshade
