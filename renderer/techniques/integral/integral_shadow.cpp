#include "techniques/integral/integral_shadow.h"

#include <array>

#include <fmt/format.h>

#include "shared/time_integral.shared.h"
#include "technique/summed_view.h"
#include "technique/technique_entry.h"

namespace timeshade {

namespace {

/// What moves: the degree of the polynomials.
unsigned motionOf(const FramePlan& plan) {
    const bool directional = plan.light.projection == Projection::Orthographic;
    // A sun's position makes no difference.
    const bool lightMoves =
        directional ? plan.block.lightDirection != plan.block.lightDirectionClose : plan.motion.lightMoves;
    if (plan.motion.movingTriangles == 0) return lightMoves ? MOTION_LIGHT : MOTION_NONE;
    return directional && !lightMoves ? MOTION_SCENE : MOTION_ALL;
}

constexpr std::array reasons{"nothing moves: constants", "the light alone moves: polynomials of degree 1",
                             "the direction of light stays: edges of degree 2, planes of degree 3",
                             "casters, receivers or light move: polynomials of degree 3"};

}  // namespace

const TechniqueDescription& IntegralShadow::describe() {
    static const TechniqueDescription description{
        .name = "integral",
        .title = "Analytic time integral",
        .shortTitle = "Integral",
        .summary =
            "Solves when each candidate triangle shadows the receiver, and takes the union of those times: the mean "
            "over a stratum without noise in time, for more arithmetic a sample.",
        .source = "this project; candidates as in exact, signs after Tang et al. 2014, roots after Yuksel 2022",
        .wrong =
            "Only where samples lie in a pixel: at the picture's edges one value stands for the whole pixel. It costs "
            "several times what a test at one instant does, most under casters that turn.",
        .look =
            "pillars with 1 sample per pixel: no noise inside the penumbrae. The view error-bound is black where "
            "the value is sure.",
        .picture = "",
        .references = {"M. Tang, R. Tong, Z. Wang, D. Manocha 2014: Fast and exact continuous collision detection with "
                       "Bernstein sign classification. ACM Transactions on Graphics 33 (6).",
                       "C. Yuksel 2022: High-performance polynomial root finding for graphics. Proceedings of the ACM "
                       "on Computer Graphics and Interactive Techniques 5 (3).",
                       "J. Palmer: Analytical motion blurred shadows. Diploma thesis, Lund University."},
    };
    return description;
}

void IntegralShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.choice(
        "over", over_, 0, {"stratum", "shutter"},
        "What a value is the mean over: the stratum of its sample, or the whole shutter, in which each sample "
        "stands for all times at its own place. That has less noise where what a pixel sees stands still, is "
        "an approximation where it moves, and costs as many times more as there are strata.");
    lists_.visitSettings(visitor);
}

Footprint IntegralShadow::footprint() const {
    return {.time = over_ == 0 ? Footprint::Time::Stratum : Footprint::Time::Shutter};
}

SamplingTraits IntegralShadow::samplingTraits() const { return {.statedError = 1e-5}; }

std::vector<PassDecision> IntegralShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes = lists_.passes(plan);
    passes.push_back(
        {"lookup",
         fmt::format("the union of the times of {} at which candidates shadow the sample's surface "
                     "point; {}{}",
                     over_ == 0 ? "a stratum" : "the shutter", reasons[motionOf(plan)], lists_.culledOf(plan)),
         0});
    return passes;
}

LookupProgram IntegralShadow::lookupProgram(const TechniqueFrame& frame, Casters) {
    LookupProgram lookup{"integral lookup", "techniques/integral/lookup.frag", {}, {}};
    lookup.defines.emplace_back("MOTION", fmt::format("{}u", motionOf(frame.plan)));
    lists_.addTo(lookup);
    return lookup;
}

std::vector<TechniqueView> IntegralShadow::views() const {
    return {{"candidates", "Candidates of a camera sample, piece by piece", "triangles", 0.0, 32.0, false},
            {"error-bound", "Bound on the error of a stratum's mean", "lit", 1e-7, 1.0, true}};
}

void IntegralShadow::drawView(const TechniqueFrame& frame, const std::string& name, const gl::Texture& values) {
    if (name != "candidates" && name != "error-bound") return Technique::drawView(frame, name, values);
    const LookupProgram lookup = lookupProgram(frame, Casters::All);
    gl::ShaderDefines defines = frame.defines();
    defines.emplace_back(name == "candidates" ? "VIEW_CANDIDATES" : "VIEW_ERROR", "1");
    if (over_ != 0) defines.emplace_back("FOOTPRINT_SHUTTER", "1");
    defines.insert(defines.end(), lookup.defines.begin(), lookup.defines.end());
    const gl::Program& program =
        programs_.get({"integral view", "passes/fullscreen.vert", lookup.fragment, std::move(defines)});
    program.use(lookup.inputs);
    drawSummedView(frame, program, viewTarget_, values);
}

StoredAlongLine IntegralShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    lists_.addMarks(frame, line, stored.marks);
    stored.note =
        "candidates: what may lie there during a bucket of the shutter, no nearer than so; when each shadows a "
        "receiver is solved";
    return stored;
}

TechniqueEntry integralTechnique() { return entryOf<IntegralShadow>(); }

}  // namespace timeshade
