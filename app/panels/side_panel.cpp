#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"

namespace timeshade {

void drawHeader(Session& session, Widgets& widgets) {
    ImGui::PushFont(ImGui::GetIO().Fonts->Fonts.back());
    ImGui::TextColored(theme::accent, "Timeshade");
    ImGui::PopFont();
    const float keys = 52.0f * widgets.scale();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - keys);
    if (widgets.button("keys", "Keys", keys)) session.panels.keysVisible = !session.panels.keysVisible;

    const gl::DeviceInfo& device = session.renderer.device();
    if (device.software) {
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        const ImVec2 end{corner.x + ImGui::GetContentRegionAvail().x, corner.y + ImGui::GetFrameHeight()};
        ImGui::GetWindowDrawList()->AddRectFilled(corner, end, ImGui::GetColorU32(ImVec4(0.36f, 0.26f, 0.08f, 1.0f)),
                                                  4.0f * widgets.scale());
        ImGui::SetCursorScreenPos({corner.x + 8.0f * widgets.scale(), corner.y});
        ImGui::AlignTextToFramePadding();
        ImGui::TextColored(theme::warning, "SOFTWARE RENDERER");
        widgets.dump().lastItem("software", true);
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("No GPU draws this: the times say nothing about one.");
    }
    widgets.paragraph(device.renderer, theme::quiet);
    widgets.dump().lastItem("renderer", device.renderer);
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s\nOpenGL %s", device.vendor.c_str(), device.version.c_str());
}

void drawSidePanel(Session& session, Widgets& widgets, const Area& area) {
    if (area.empty()) return;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    // The scroll bar is always there, so that unfolding a section does not shift everything sideways.
    if (ImGui::Begin("settings", nullptr,
                     (flags & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysVerticalScrollbar)) {
        drawHeader(session, widgets);
        drawScenePanel(session, widgets);
        drawTechniquePanel(session, widgets);
        drawComparePanel(session, widgets);
        drawSamplingPanel(session, widgets);
        drawTimePanel(session, widgets);
        drawViewPanel(session, widgets);
        drawLightPanel(session, widgets);
        drawGroundPanel(session, widgets);
        drawCameraPanel(session, widgets);
        drawTimesPanel(session, widgets);
        drawAccuracyPanel(session, widgets);
        drawPlanPanel(session, widgets);
        drawSettingsPanel(session, widgets);
    }
    ImGui::End();
}

}  // namespace timeshade
