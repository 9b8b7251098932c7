#include <filesystem>

#include "panels/panels.h"
#include "panels/theme.h"
#include "window/settings_io.h"

namespace timeshade {

void drawSettingsPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.settings", "Settings", true)) return;
    if (widgets.button("settings.command", "Copy command line (Ctrl-C)", ImGui::GetContentRegionAvail().x))
        session.wishedCommand = true;
    if (!session.lastCommand.empty()) widgets.dump().lastItem("settings.command", session.lastCommand);
    widgets.field("settings.path", "a JSON file", session.settingsPath, 0.0f);
    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (widgets.button("settings.save", "Save (Ctrl-S)", half)) session.wishedSave = true;
    ImGui::SameLine();
    if (widgets.button("settings.load", "Load (Ctrl-O)", half)) session.wishedLoad = session.settingsPath;
    widgets.paragraph("The file is what --settings takes.", theme::quiet);
}

}  // namespace timeshade
