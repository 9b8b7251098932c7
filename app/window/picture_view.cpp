#include "window/picture_view.h"

#include <algorithm>
#include <cstdint>

#include <imgui.h>

#include "panels/comparison_view.h"
#include "panels/imgui_versions.h"
#include "window/session.h"

namespace timeshade {

namespace {

/// As large as fits, in the centre. Its rows go downwards.
void drawFitted(const gl::Texture& picture, const Area& area) {
    const auto width = static_cast<float>(picture.width()), height = static_cast<float>(picture.height());
    const float factor = std::min(area.size.x / width, area.size.y / height);
    const ImVec2 corner{area.position.x + 0.5f * (area.size.x - factor * width),
                        area.position.y + 0.5f * (area.size.y - factor * height)};
    ImGui::GetBackgroundDrawList()->AddImage(imguiId(picture), corner,
                                             {corner.x + factor * width, corner.y + factor * height});
}

/// OpenGL's rows go upwards.
void drawFilling(const gl::Texture& picture, const Area& area) {
    const ImVec2 end{area.position.x + area.size.x, area.position.y + area.size.y};
    ImGui::GetBackgroundDrawList()->AddImage(imguiId(picture), area.position, end, {0.0f, 1.0f}, {1.0f, 0.0f});
}

}  // namespace

void drawPictureView(Session& session, Widgets& widgets, const Area& area) {
    const Comparison& comparison = session.comparison;
    if (comparison.on() && (comparison.picture() != nullptr || !comparison.complaint().empty()))
        drawComparison(session, widgets, area);
    else if (const gl::Texture* diagnostic = session.diagnosticPicture.picture())
        drawFitted(*diagnostic, area);
    else if (const gl::Texture* picture = session.driver.picture())
        drawFilling(*picture, area);
}

}  // namespace timeshade
