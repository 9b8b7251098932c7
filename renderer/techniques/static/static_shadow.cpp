#include "techniques/static/static_shadow.h"

#include "technique/technique_entry.h"

namespace timeshade {

const TechniqueDescription& StaticShadow::describe() {
    static const TechniqueDescription description{
        .name = "static",
        .title = "Static shadow map",
        .shortTitle = "Static map",
        .summary = "One ordinary shadow map at the centre of the shutter: the cheapest, and blind to motion.",
        .source = "Williams 1978; PCF: Reeves, Salesin, Cook 1987",
        .wrong = "All motion: whatever moves throws the sharp shadow of one instant, the centre of the shutter.",
        .look = "octopus: the arms are blurred, their shadows are not.",
        .picture = "Shadows of arms: left static, right ground truth.",
        .references = {"L. Williams 1978: Casting curved shadows on curved surfaces. SIGGRAPH.",
                       "W. Reeves, D. Salesin, R. Cook 1987: Rendering antialiased shadows with depth maps. SIGGRAPH."},
    };
    return description;
}

std::vector<PassDecision> StaticShadow::passes(const FramePlan& plan) const {
    return {{"build", "one ordinary shadow map at u = 0.5; motion is ignored on purpose", plan.motion.triangles},
            {"lookup", "each camera sample's surface point, taken to u = 0.5, against that map", 0}};
}

TechniqueEntry staticTechnique() { return entryOf<StaticShadow>(); }

}  // namespace timeshade
