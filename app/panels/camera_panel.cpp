#include <utility>

#include <fmt/format.h>

#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

void drawCameraPanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.camera", "Camera", true)) return;
    std::vector<std::string> names;
    for (const CameraBookmark& bookmark : session.scene.current().cameras())
        names.push_back(bookmark.name.empty() ? fmt::format("Camera {}", names.size() + 1) : bookmark.name);
    const std::size_t free = names.size();
    if (session.camera.orbit) names.push_back("Free camera");
    if (const auto chosen =
            widgets.combo("camera", "", names, session.camera.orbit ? free : session.moment.request.cameraIndex, ""))
        if (*chosen < free) session.camera.useSceneCamera(session.moment, *chosen);

    const float save = 82.0f * widgets.scale();
    const bool entered = widgets.field("camera.name", "name of a view to save", session.panels.viewName,
                                       save + ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine();
    if (widgets.button("camera.save", "Save view", save) || entered)
        session.camera.save(session.scene.current(), session.moment, std::exchange(session.panels.viewName, {}));
    if (widgets.button("camera.reset", "Reset (R)", ImGui::GetContentRegionAvail().x))
        session.camera.useSceneCamera(session.moment, session.moment.request.cameraIndex);

    std::optional<std::size_t> dropped;
    const float cross = 18.0f * widgets.scale();
    for (std::size_t i = 0; i < session.camera.savedViews.size(); ++i) {
        const SavedView& saved = session.camera.savedViews[i];
        ImGui::PushID(static_cast<int>(i));
        const float width = ImGui::GetContentRegionAvail().x - cross - ImGui::GetStyle().ItemSpacing.x;
        if (widgets.button(fmt::format("camera.view.{}", i + 1), saved.name, width))
            session.camera.orbit = saved.camera;
        ImGui::SameLine();
        if (widgets.iconButton(fmt::format("camera.drop.{}", i + 1), Icon::Close, "Delete view", cross)) dropped = i;
        ImGui::PopID();
    }
    if (dropped)
        session.camera.savedViews.erase(session.camera.savedViews.begin() + static_cast<std::ptrdiff_t>(*dropped));
    widgets.paragraph(
        "In the picture: drag to orbit, right-drag to pan, wheel to zoom, double-click to focus; W A S D to fly.",
        theme::quiet);
}

}  // namespace timeshade
