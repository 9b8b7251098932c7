#include <algorithm>

#include "panels/panels.h"
#include "panels/theme.h"
#include "techniques/registry.h"

namespace timeshade {

void drawComparePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.compare", "Compare", true)) return;
    Comparison& comparison = session.comparison;
    std::vector<std::string> titles{"None"}, names{""}, ids{"none"};
    std::size_t current = 0;
    for (const TechniqueDescription& description : techniqueDescriptions()) {
        if (comparison.on() && comparison.technique()->description().name == description.name) current = names.size();
        titles.push_back(description.shortTitle);
        names.push_back(description.name);
        ids.push_back(description.name);
    }
    const auto chosen = widgets.combo("compare", "With", titles, current,
                                      "A second technique, drawn of the same frame with the same camera samples.", ids);
    if (chosen && *chosen != current) session.requests.comparison = names[*chosen];
    if (widgets.button("compare.pin", "Snapshot as B", ImGui::GetContentRegionAvail().x))
        session.requests.snapshot = true;
    if (!comparison.on()) return;
    const std::size_t mode = comparison.flip ? 3 : static_cast<std::size_t>(comparison.mode);
    if (const auto picked = widgets.choice("compare.mode", {"Wipe", "Side by side", "Difference", "A/B flip"}, mode,
                                           {"wipe", "side", "difference", "flip"})) {
        comparison.flip = *picked == 3;
        comparison.mode = comparison.flip ? CompareMode::Wipe : static_cast<CompareMode>(*picked);
    }
    if (widgets.button("compare.swap", "Swap A/B (X)", ImGui::GetContentRegionAvail().x)) session.requests.swap = true;
    widgets.paragraph(comparison.flip                        ? "Hold F to see B."
                      : comparison.mode == CompareMode::Wipe ? "Drag the seam in the picture; hold F to see B alone."
                                                             : "Hold F to see B alone.",
                      theme::quiet);
}

}  // namespace timeshade
