#include <algorithm>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

void drawStory(Session& session, Widgets& widgets, const Area& picture) {
    if (session.comparison.technique() == nullptr) return;
    const float unit = widgets.scale(), margin = 12.0f * unit;
    const float width = std::min(340.0f * unit, picture.size.x - 2.0f * margin);
    if (width < 120.0f * unit || picture.size.y < 160.0f * unit) return;
    ImGui::SetNextWindowPos({picture.position.x + margin, picture.position.y + picture.size.y - margin},
                            ImGuiCond_Always, {0.0f, 1.0f});
    ImGui::SetNextWindowSize({width, 0.0f});
    ImGui::SetNextWindowBgAlpha(0.9f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f);
    const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                   ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;
    if (ImGui::Begin("story", nullptr, flags)) {
        const TechniqueDescription& left = session.technique.current().description();
        const TechniqueDescription& right = session.comparison.technique()->description();
        widgets.paragraph("Shadows of what moves", theme::accent);
        widgets.paragraph(fmt::format("Left: {}. {}", left.shortTitle, left.summary), theme::text);
        widgets.paragraph(fmt::format("Right: {}. {}", right.shortTitle, right.summary), theme::text);
        widgets.paragraph("Drag the seam. M on a blurred edge shows its samples. ? lists the keys.", theme::quiet);
        widgets.dump().lastItem("story", session.panels.storyVisible);
        if (widgets.button("story.close", "Close for good")) {
            session.panels.storyVisible = false;
            session.panels.storyClosed = true;
        }
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

}  // namespace timeshade
