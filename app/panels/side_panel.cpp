#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "panels/imgui_versions.h"
#include "panels/panels.h"
#include "panels/theme.h"
#include "report.h"

namespace timeshade {

void drawHeader(Session& session, Widgets& widgets) {
    pushFont(ImGui::GetIO().Fonts->Fonts.back());
    ImGui::TextColored(theme::accent, "Timeshade");
    ImGui::PopFont();
    const float keys = 52.0f * widgets.scale();
    ImGui::SameLine(contentRight() - keys);
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

namespace {

constexpr std::array<const char*, 4> tabIds{"scene", "technique", "compare", "measure"};

void drawTabs(Session& session, Widgets& widgets) {
    const auto found = std::find(tabIds.begin(), tabIds.end(), session.panels.tab);
    const auto current = static_cast<std::size_t>(found - tabIds.begin());
    const std::vector<std::string> ids(tabIds.begin(), tabIds.end());
    if (const auto chosen = widgets.tabs("tab", {"Scene", "Technique", "Compare", "Measure"}, current, ids))
        session.panels.tab = tabIds[*chosen];
}

void drawTab(Session& session, Widgets& widgets) {
    const std::string tab = session.panels.tab;
    if (tab == "scene") {
        drawScenePanel(session, widgets);
        drawCasePanel(session, widgets);
        drawTimePanel(session, widgets);
        drawLightPanel(session, widgets);
        drawGroundPanel(session, widgets);
        drawCameraPanel(session, widgets);
    } else if (tab == "technique") {
        drawTechniquePanel(session, widgets);
        drawSamplingPanel(session, widgets);
        drawViewPanel(session, widgets);
        drawSettingsPanel(session, widgets);
    } else if (tab == "compare") {
        drawComparePanel(session, widgets);
    } else {
        drawTimesPanel(session, widgets);
        drawAccuracyPanel(session, widgets);
        drawPlanPanel(session, widgets);
    }
}

/// The edge between panel and picture, which the mouse can drag. In a window of its own, over both.
void drawEdge(Session& session, Widgets& widgets, const Area& area) {
    const float width = 6.0f * widgets.scale();
    ImGui::SetNextWindowPos({area.position.x + area.size.x - 0.5f * width, area.position.y});
    ImGui::SetNextWindowSize({width, area.size.y});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::Begin("panel edge", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoNav);
    ImGui::InvisibleButton("panel.edge", {width, area.size.y});
    widgets.dump().lastItem("panel.edge", area.size.x);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsItemActive() && ImGui::IsMouseDragging(0))
        session.panels.width = std::max(200.0f, (ImGui::GetIO().MousePos.x - area.position.x) / widgets.scale());
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) session.panels.width = 0.0f;
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace

void drawSidePanel(Session& session, Widgets& widgets, const Area& area) {
    if (area.empty()) return;
    ImGui::SetNextWindowPos(area.position);
    ImGui::SetNextWindowSize(area.size);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoBringToFrontOnFocus;
    if (ImGui::Begin("settings", nullptr, flags | ImGuiWindowFlags_NoScrollWithMouse)) {
        drawHeader(session, widgets);
        drawTabs(session, widgets);
        // The scroll bar is always there, so that unfolding a section does not shift everything sideways.
        if (ImGui::BeginChild(session.panels.tab.c_str(), {0.0f, 0.0f}, false,
                              ImGuiWindowFlags_AlwaysVerticalScrollbar))
            drawTab(session, widgets);
        ImGui::EndChild();
    }
    ImGui::End();
    drawEdge(session, widgets, area);
}

}  // namespace timeshade
