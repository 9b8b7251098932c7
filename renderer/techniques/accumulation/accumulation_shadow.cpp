#include "techniques/accumulation/accumulation_shadow.h"

#include <fmt/format.h>

#include "technique/technique_entry.h"
namespace timeshade {

const TechniqueDescription& AccumulationShadow::describe() {
    static const TechniqueDescription description{
        .name = "accumulation",
        .title = "Accumulation (brute force)",
        .shortTitle = "Accumulation",
        .summary =
            "The whole frame drawn M times at M instants with an ordinary shadow map, and averaged: slow and nearly "
            "right.",
        .source = "Haeberli, Akeley 1990",
        .wrong =
            "Nothing in time beyond half a step between two renders, but a fast thing becomes as many copies as there "
            "are renders; the map's resolution; its price, since everything is drawn again for each.",
        .look = "octopus with 8 renders and with 256.",
        .picture = "Tips of arms: left 6 renders, right ground truth.",
        .references = {"P. Haeberli, K. Akeley 1990: The accumulation buffer: hardware support for high-quality "
                       "rendering. SIGGRAPH."},
    };
    return description;
}

void AccumulationShadow::visitSettings(SettingsVisitor& visitor) {
    visitor.whole("renders", renders_, 256, 1, 4096, "renders",
                  "How many instants of the shutter are drawn. Time and cost are in proportion; few show as separate "
                  "copies of the shadow.",
                  true);
    map_.visitSettings(visitor);
}

std::vector<PassDecision> AccumulationShadow::passes(const FramePlan& plan) const {
    return {{"build", fmt::format("{} ordinary shadow maps, one an instant", renders_), plan.motion.triangles},
            {"lookup", fmt::format("one camera sample per pixel and instant, {} in all; --spp has no effect", renders_),
             0}};
}

StoredAlongLine AccumulationShadow::storedAlong(const TechniqueFrame& frame, const MapLine& line) {
    // A render stands for its share of the shutter.
    const auto u = static_cast<double>(OrdinaryMap::instantOf(frame.plan));
    StoredAlongLine stored = map_.storedAlong(frame, line, u - 0.5 / renders_, u + 0.5 / renders_);
    stored.note = fmt::format("{} maps, each of the instant at the centre of its interval", renders_);
    return stored;
}

TechniqueEntry accumulationTechnique() { return entryOf<AccumulationShadow>(); }

}  // namespace timeshade
