#include "panels/panels.h"
#include "panels/setting_controls.h"
#include "panels/theme.h"
#include "report.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

/// What it counted in the picture, with warnings.
void drawStatistics(Session& session, Widgets& widgets) {
    for (const TechniqueStatistic& figure : session.technique.statistics(session.driver)) {
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
    const TechniqueDescription& now = session.technique.current().description();
    std::vector<std::string> titles;
    std::size_t current = 0;
    for (const TechniqueDescription& description : all) {
        if (description.name == now.name) current = titles.size();
        titles.push_back(description.title);
    }
    if (const auto chosen = widgets.combo("technique", "", titles, current, ""))
        session.requests.technique = all[*chosen].name;
    widgets.paragraph(now.summary, theme::quiet);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", now.source.c_str());

    if (widgets.button("technique.page", "About this technique (I)", ImGui::GetContentRegionAvail().x))
        session.panels.pageVisible = !session.panels.pageVisible;
    drawSettings(session.technique.current(), "technique.reset", widgets);
    drawStatistics(session, widgets);
}

}  // namespace timeshade
