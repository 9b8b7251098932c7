#include "panels/panels.h"
#include "panels/setting_controls.h"
#include "panels/theme.h"
#include "report.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

/// What it counted in the picture, and what to beware of.
void drawStatistics(Session& session, Widgets& widgets) {
    for (const TechniqueStatistic& figure : session.statistics()) {
        widgets.figure("figure." + figure.name, figure.name, inWords(figure));
        if (figure.warning.empty()) continue;
        widgets.paragraph(figure.warning, theme::warning);
        widgets.dump().lastItem("figure.warning." + figure.name, figure.warning);
    }
}

}  // namespace

void drawTechniquePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.technique", "Technique", true)) return;
    const std::vector<TechniqueDescription>& all = techniqueDescriptions();
    const TechniqueDescription& now = session.technique->description();
    std::vector<std::string> titles;
    std::size_t current = 0;
    for (const TechniqueDescription& description : all) {
        if (description.name == now.name) current = titles.size();
        titles.push_back(description.title);
    }
    if (const auto chosen = widgets.combo("technique", "", titles, current, ""))
        session.wishedTechnique = all[*chosen].name;
    widgets.paragraph(now.summary, theme::quiet);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", now.source.c_str());

    if (widgets.button("technique.page", "About this technique (I)", ImGui::GetContentRegionAvail().x))
        session.pageVisible = !session.pageVisible;
    drawSettings(*session.technique, "technique.reset", widgets);
    drawStatistics(session, widgets);
}

}  // namespace timeshade
