#include <algorithm>

#include "panels/panels.h"
#include "panels/theme.h"
#include "window/chips.h"

namespace timeshade {

void drawChips(Session& session, Widgets& widgets, const Area& picture) {
    const std::vector<Chip> chips = chipsOf(session);
    std::vector<std::string> ids;
    for (const Chip& chip : chips) ids.push_back(chip.id);
    widgets.dump().state("chips", ids);
    if (chips.empty()) return;
    const float margin = 8.0f * widgets.scale();
    // Below the labels of a comparison.
    const float top = session.comparison.on() ? ImGui::GetTextLineHeight() + 3.0f * margin : margin;
    // Measured here: the window's own size is that of the chips of the frame before.
    float width = ImGui::GetStyle().ItemSpacing.x * static_cast<float>(chips.size() - 1);
    for (const Chip& chip : chips)
        width += ImGui::CalcTextSize(chip.text.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    const float right = picture.position.x + picture.size.x - margin;
    ImGui::SetNextWindowPos({right - width, picture.position.y + top});
    ImGui::SetNextWindowBgAlpha(0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0.0f, 0.0f});
    ImGui::PushStyleVar(ImGuiStyleVar_FrameRounding, 9.0f * widgets.scale());
    ImGui::PushStyleColor(ImGuiCol_Button, ImVec4(0.05f, 0.05f, 0.06f, 0.78f));
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("chips", nullptr, flags)) {
        for (const Chip& chip : chips) {
            if (&chip != &chips.front()) ImGui::SameLine();
            const bool quiet = chip.id == "cached";
            ImGui::PushStyleColor(ImGuiCol_Text, quiet ? theme::quiet : theme::warning);
            if (widgets.button("chip." + chip.id, chip.text)) leaveState(session, chip.id);
            ImGui::PopStyleColor();
            if (ImGui::IsItemHovered()) ImGui::SetTooltip("%s", chip.tooltip.c_str());
        }
    }
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

}  // namespace timeshade
