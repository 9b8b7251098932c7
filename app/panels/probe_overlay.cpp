#include <algorithm>
#include <cstdint>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

/// Cells from the shutter's opening to its closing, white where lit.
void drawStrip(const PixelProbe::Row& row, float width, float height) {
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const auto count = static_cast<float>(row.lit.size());
    for (std::size_t k = 0; k < row.lit.size(); ++k) {
        const float lit = row.lit[k];
        const ImVec4 color = lit < 0.0f ? ImVec4(0.20f, 0.22f, 0.30f, 1.0f)
                                        : ImVec4(0.08f + 0.88f * lit, 0.08f + 0.84f * lit, 0.08f + 0.70f * lit, 1.0f);
        list.AddRectFilled({corner.x + width * static_cast<float>(k) / count, corner.y},
                           {corner.x + width * static_cast<float>(k + 1) / count - 1.0f, corner.y + height},
                           ImGui::GetColorU32(color));
    }
    ImGui::Dummy({width, height});
}

}  // namespace

void drawProbe(Session& session, Widgets& widgets, const Area& picture) {
    const PixelProbe& probe = session.probe;
    if (!probe.on() || probe.square() == nullptr) return;
    const float unit = widgets.scale(), square = 8.0f * PixelProbe::side * unit;
    const ImVec2 end{picture.position.x + picture.size.x - 10.0f * unit,
                     picture.position.y + picture.size.y - 10.0f * unit};
    ImGui::SetNextWindowPos(end, ImGuiCond_Always, {1.0f, 1.0f});
    ImGui::SetNextWindowBgAlpha(0.94f);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("probe", nullptr, flags)) {
        ImGui::BeginGroup();
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::Image(reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(probe.square()->name())),
                     {square, square});
        const float middle = 8.0f * unit * static_cast<float>(PixelProbe::side / 2);
        ImGui::GetWindowDrawList()->AddRect({corner.x + middle, corner.y + middle},
                                            {corner.x + middle + 8.0f * unit, corner.y + middle + 8.0f * unit},
                                            ImGui::GetColorU32(theme::accent));
        ImGui::TextColored(theme::quiet, "pixel %d, %d, 8 x", probe.x(), probe.y());
        ImGui::EndGroup();
        ImGui::SameLine();
        ImGui::BeginGroup();
        ImGui::TextColored(theme::quiet, "lit, from the shutter's opening to its closing");
        for (const PixelProbe::Row& row : probe.rows()) {
            drawStrip(row, 150.0f * unit, 11.0f * unit);
            ImGui::SameLine();
            ImGui::Text("%.2f  %s", row.mean(), row.name.c_str());
            widgets.dump().lastItem("probe." + row.name, row.lit);
        }
        if (!probe.caption().empty()) ImGui::TextColored(theme::warning, "%s", probe.caption().c_str());
        ImGui::EndGroup();
    }
    ImGui::End();
}

}  // namespace timeshade
