#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

void drawCameraPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.camera", "Camera", true)) return;
    std::vector<std::string> names;
    for (const CameraBookmark& bookmark : session.scene->cameras())
        names.push_back(bookmark.name.empty() ? fmt::format("camera {}", names.size() + 1) : bookmark.name);
    const std::size_t free = names.size();
    if (session.camera) names.push_back("moved by hand");
    if (const auto chosen = widgets.combo("camera", "", names, session.camera ? free : session.request.cameraIndex, ""))
        if (*chosen < free) session.useSceneCamera(*chosen);

    const float half = 0.5f * (ImGui::GetContentRegionAvail().x - ImGui::GetStyle().ItemSpacing.x);
    if (widgets.button("camera.save", "Keep this view", half)) {
        const std::string name = fmt::format("View {}", session.savedViews.size() + 1);
        session.savedViews.push_back(
            {name, session.camera ? *session.camera : OrbitCamera(session.currentPose(), session.scene->bounds())});
    }
    ImGui::SameLine();
    if (widgets.button("camera.reset", "Reset (R)", half)) session.useSceneCamera(session.request.cameraIndex);

    std::optional<std::size_t> dropped;
    const float cross = 18.0f * widgets.scale();
    for (std::size_t i = 0; i < session.savedViews.size(); ++i) {
        const SavedView& saved = session.savedViews[i];
        ImGui::PushID(static_cast<int>(i));
        const float width = ImGui::GetContentRegionAvail().x - cross - ImGui::GetStyle().ItemSpacing.x;
        if (widgets.button(fmt::format("camera.view.{}", i + 1), saved.name, width)) session.camera = saved.camera;
        ImGui::SameLine();
        if (widgets.iconButton(fmt::format("camera.drop.{}", i + 1), Icon::Close, "forget this view", cross))
            dropped = i;
        ImGui::PopID();
    }
    if (dropped) session.savedViews.erase(session.savedViews.begin() + static_cast<std::ptrdiff_t>(*dropped));
    widgets.paragraph("In the picture: drag to orbit, right-drag to pan, wheel to zoom.", theme::quiet);
}

}  // namespace timeshade
