#include <filesystem>

#include "panels/panels.h"
#include "panels/theme.h"
#include "window/settings_io.h"

namespace timeshade {

void drawSettingsPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.settings", "Settings", true)) return;
    if (widgets.button("settings.command", "Copy command line (Ctrl-C)", ImGui::GetContentRegionAvail().x))
        session.requests.command = true;
    if (!session.panels.lastCommand.empty()) widgets.dump().lastItem("settings.command", session.panels.lastCommand);
    widgets.field("settings.path", "JSON file", session.panels.settingsPath, 0.0f);
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (widgets.button("settings.save", "Save (Ctrl-S)", half)) session.requests.save = true;
    ImGui::SameLine();
    if (widgets.button("settings.load", "Load (Ctrl-O)", half)) session.requests.load = session.panels.settingsPath;
    widgets.paragraph("The file is what --settings takes.", theme::quiet);
}

}  // namespace timeshade
