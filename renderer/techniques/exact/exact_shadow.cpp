#include "techniques/exact/exact_shadow.h"

#include "technique/summed_view.h"
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

void ExactShadow::visitSettings(SettingsVisitor& visitor) { lists_.visitSettings(visitor); }

std::vector<PassDecision> ExactShadow::passes(const FramePlan& plan) const {
    std::vector<PassDecision> passes = lists_.passes(plan);
    passes.push_back({"lookup",
                      "each camera sample against the triangles of its own cell and bucket, at its own time and place" +
                          lists_.culledOf(plan),
                      0});
    return passes;
}

LookupProgram ExactShadow::lookupProgram(const TechniqueFrame&, Casters) {
    LookupProgram lookup{"exact lookup", "techniques/exact/lookup.frag", {}, {}};
    lists_.addTo(lookup);
    return lookup;
}

std::vector<TechniqueView> ExactShadow::views() const {
    return {{"candidates", "Candidates of a camera sample", "triangles", 0.0, 32.0, false}};
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
    drawSummedView(frame, program, viewTarget_, values);
}

StoredAlongLine ExactShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    StoredAlongLine stored;
    lists_.addMarks(frame, line, stored.marks);
    stored.note =
        "candidates: what may lie there during a bucket of the shutter, no nearer than so; each is tested exactly";
    return stored;
}

TechniqueEntry exactTechnique() { return entryOf<ExactShadow>(); }

}  // namespace timeshade
