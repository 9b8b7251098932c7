#include "panels/panels.h"
#include "panels/setting_controls.h"
#include "panels/theme.h"
#include "report.h"
#include "techniques/registry.h"

namespace timeshade {

namespace {

/// What it counted in the picture, with warnings.
void drawStatistics(Session& session, Widgets& widgets) {
    if (!widgets.section("section.statistics", "Statistics", false)) return;
    if (session.driver.shown().preview) widgets.paragraph("Of the preview", theme::warning);
    const bool playing = session.moment.playback.playing();
    for (const TechniqueStatistic& figure : session.technique.statistics(session.driver, playing, session.now)) {
        widgets.figure("figure." + figure.name, figure.name, inWords(figure));
        if (figure.warning.empty()) continue;
        widgets.paragraph(figure.warning, theme::warning);
        widgets.dump().lastItem("figure.warning." + figure.name, figure.warning);
    }
}

void drawSamples(Session& session, Widgets& widgets) {
    Widgets::Number samples;
    samples.minimum = 1.0;
    samples.maximum = maximumSamplesPerPixel;
    samples.format = "%d";
    samples.defaultValue = 8.0;
    samples.help =
        "Camera samples of each pixel, one per stratum of the shutter. Less noise; time in proportion. A "
        "technique that accumulates renders draws as many as it has renders.";
    widgets.slider("spp", "Samples per pixel", session.moment.request.samplesPerPixel, samples);
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
        titles.push_back(description.shortTitle);
    }
    if (const auto chosen = widgets.combo("technique", "", titles, current, ""))
        session.requests.technique = all[*chosen].name;
    if (ImGui::IsItemHovered())
        ImGui::SetTooltip("%s\n%s\n%s", now.title.c_str(), now.summary.c_str(), now.source.c_str());
    drawSamples(session, widgets);
    drawSettings(session.technique.current(), "technique.reset", widgets);
    widgets.paragraph(now.title + ". " + now.summary, theme::quiet);
    if (widgets.button("technique.page", "About this technique (I)", ImGui::GetContentRegionAvail().x))
        session.panels.pageVisible = !session.panels.pageVisible;
    drawStatistics(session, widgets);
}

}  // namespace timeshade
