#include <algorithm>

#include "panels/panels.h"
#include "panels/theme.h"
#include "techniques/registry.h"

namespace timeshade {

void drawComparePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.compare", "Compare", true)) return;
    Comparison& comparison = session.comparison;
    std::vector<std::string> names{"nothing"};
    std::size_t current = 0;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        if (comparison.on() && comparison.technique()->description().name == description.name) current = names.size();
        names.push_back(description.name);
    }
    const auto chosen = widgets.combo("compare", "With", names, current,
                                      "A second technique, drawn of the same moment with the same camera samples.");
    if (chosen && *chosen != current) session.wishedComparison = *chosen == 0 ? "" : names[*chosen];
    if (widgets.button("compare.pin", "Keep the settings of now as second", ImGui::GetContentRegionAvail().x))
        session.wishedPin = true;
    if (!comparison.on()) return;
    const std::size_t mode = comparison.flip ? 3 : static_cast<std::size_t>(comparison.mode);
    if (const auto picked = widgets.choice("compare.mode", {"wipe", "side", "difference", "flip"}, mode)) {
        comparison.flip = *picked == 3;
        comparison.mode = comparison.flip ? CompareMode::Wipe : static_cast<CompareMode>(*picked);
    }
    if (widgets.button("compare.swap", "Exchange the two (X)", ImGui::GetContentRegionAvail().x))
        session.wishedSwap = true;
    widgets.paragraph(comparison.flip ? "Hold F to see the second."
                      : comparison.mode == CompareMode::Wipe
                          ? "Drag the seam in the picture; hold F to see the second alone."
                          : "Hold F to see the second alone.",
                      theme::quiet);
}

}  // namespace timeshade
