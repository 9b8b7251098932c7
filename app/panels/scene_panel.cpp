#include <algorithm>
#include <filesystem>

#include "frame_setup.h"
#include "panels/panels.h"
#include "panels/setting_controls.h"
#include "panels/theme.h"
#include "scene_catalogue.h"

namespace timeshade {

namespace {

/// The analytic cases, in a list of their own: there are many.
void drawCaseList(Session& session, Widgets& widgets) {
    std::vector<std::string> names{"Analytic cases"};
    std::size_t current = 0;
    for (const BuiltInScene& scene : caseScenes()) {
        if (scene.name == session.scene.name()) current = names.size();
        names.push_back(scene.name);
    }
    if (const auto chosen = widgets.combo("scene.case", "", names, current, ""))
        if (*chosen != current && *chosen > 0) session.requests.scene = names[*chosen];
}

void drawClipList(Session& session, Widgets& widgets) {
    const std::vector<std::string>& clips = session.scene.current().clips();
    if (clips.size() < 2) return;
    const auto chosen = widgets.combo("scene.clip", "Clip", clips, session.scene.current().clip(),
                                      "Which of the file's animations plays.");
    if (!chosen || *chosen == session.scene.current().clip()) return;
    SceneChoice choice = choiceOf(session.options);
    choice.clip = clips[*chosen];
    session.requests.choice = choice;
}

}  // namespace

void drawScenePanel(Session& session, Widgets& widgets) {
    if (!widgets.section("section.scene", "Scene", true)) return;
    std::vector<std::string> names;
    for (const BuiltInScene& scene : builtInScenes()) names.push_back(scene.name);
    auto current =
        static_cast<std::size_t>(std::find(names.begin(), names.end(), session.scene.name()) - names.begin());
    const bool builtIn = current < names.size();
    if (!builtIn) names.push_back(std::filesystem::path(session.scene.name()).filename().string());
    if (const auto chosen = widgets.combo("scene", "", names, current, ""))
        if (*chosen != current) session.requests.scene = names[*chosen];
    drawCaseList(session, widgets);
    if (builtIn) widgets.paragraph(builtInScenes()[current].summary, theme::quiet);
    if (session.scene.recipe() != nullptr && drawSettings(*session.scene.recipe(), "scene.reset", widgets))
        session.requests.rebuild = true;

    const float width = 52.0f * widgets.scale();
    const bool entered = widgets.field("scene.path", "path of a .gltf or .glb file", session.panels.scenePath,
                                       width + ImGui::GetStyle().ItemSpacing.x);
    ImGui::SameLine();
    const bool pressed = widgets.button("scene.open", "Open", width);
    if ((entered || pressed) && !session.panels.scenePath.empty()) session.requests.scene = session.panels.scenePath;
    if (!session.recentFiles.paths().empty()) {
        std::vector<std::string> recent{"Recent files"};
        for (const std::string& path : session.recentFiles.paths())
            recent.push_back(std::filesystem::path(path).filename().string());
        if (const auto chosen = widgets.combo("scene.recent", "", recent, 0, ""))
            if (*chosen > 0) session.requests.scene = session.recentFiles.paths()[*chosen - 1];
    }
    drawClipList(session, widgets);
    if (!session.panels.sceneError.empty()) {
        widgets.paragraph(session.panels.sceneError, theme::bad);
        widgets.dump().lastItem("scene.error", session.panels.sceneError);
    }
    for (const std::string& note : session.scene.current().notes()) widgets.paragraph("note: " + note, theme::warning);
}

}  // namespace timeshade
