#include "techniques/static/static_shadow.h"

namespace timeshade {

const TechniqueDescription& StaticShadow::describe() {
    static const TechniqueDescription description{
        "static", "Static shadow map",
        "One ordinary shadow map at the middle of the shutter: the cheapest, and blind to motion.",
        "Williams 1978; PCF: Reeves, Salesin, Cook 1987"};
    return description;
}

std::vector<PassDecision> StaticShadow::passes(const FramePlan& plan) const {
    return {{"build", "one ordinary shadow map at u = 0.5; motion is ignored on purpose", plan.motion.triangles},
            {"lookup", "each camera sample's surface point, taken to u = 0.5, against that map", 0}};
}

}  // namespace timeshade
