#include "techniques/accumulation/accumulation_shadow.h"

#include <fmt/format.h>

namespace timeshade {

const TechniqueDescription& AccumulationShadow::describe() {
    static const TechniqueDescription description{
        "accumulation", "Accumulation (brute force)",
        "The whole frame drawn M times at M instants with an ordinary shadow map, and averaged: slow and nearly right.",
        "Haeberli, Akeley 1990"};
    return description;
}

void AccumulationShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("renders", renders_, 256, 1, 4096, "renders",
                  "How many instants of the shutter are drawn. Time and cost are in proportion; few show as separate "
                  "copies of the shadow.",
                  true);
    shadow_.visitSettings(visitor);
}

std::vector<PassDecision> AccumulationShadow::passes(const FramePlan& plan) const {
    return {{"build", fmt::format("{} ordinary shadow maps, one an instant", renders_), plan.motion.triangles},
            {"lookup", fmt::format("one camera sample per pixel and instant, {} in all; --spp has no effect", renders_),
             0}};
}

}  // namespace timeshade
