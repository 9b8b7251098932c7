#include <algorithm>
#include <array>
#include <cstdint>

#include "panels/imgui_versions.h"
#include "panels/panels.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

constexpr ImGuiWindowFlags boxFlags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                      ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_AlwaysAutoResize |
                                      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoNav;

/// A box over the picture; (0.5, 0.5) is its centre. Its text wraps within the picture.
void beginBox(const char* name, const Area& picture, ImVec2 place, float width, const ImVec4& border) {
    ImGui::SetNextWindowPos(
        {picture.position.x + place.x * picture.size.x, picture.position.y + place.y * picture.size.y},
        ImGuiCond_Always, place);
    ImGui::SetNextWindowSizeConstraints({1.0f, 1.0f}, {std::max(1.0f, picture.size.x), std::max(1.0f, picture.size.y)});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 1.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 6.0f);
    ImGui::PushStyleColor(ImGuiCol_Border, border);
    ImGui::SetNextWindowBgAlpha(0.94f);
    ImGui::Begin(name, nullptr, boxFlags);
    ImGui::PushTextWrapPos(std::min(width, std::max(40.0f, picture.size.x - 60.0f)));
}

void endBox() {
    ImGui::PopTextWrapPos();
    ImGui::End();
    ImGui::PopStyleColor();
    ImGui::PopStyleVar(2);
}

void drawFailure(const Session& session, Widgets& widgets, const Area& picture) {
    beginBox("failure", picture, {0.5f, 0.5f}, 420.0f * widgets.scale(), theme::bad);
    ImGui::TextColored(theme::bad, "This frame can't be rendered");
    ImGui::TextUnformatted(session.driver.failure().c_str());
    widgets.dump().lastItem("failure", session.driver.failure());
    ImGui::TextColored(theme::quiet, "Change the technique, the scene or a setting to go on.");
    endBox();
}

void drawShaderLog(const Session& session, Widgets& widgets, const Area& picture) {
    beginBox("shaders", picture, {0.5f, 0.12f}, 520.0f * widgets.scale(), theme::bad);
    ImGui::TextColored(theme::bad, "Shaders can't be built: the last good ones stay in use");
    constexpr std::size_t shown = 6;
    for (std::size_t i = 0; i < std::min(shown, session.shaders.log.size()); ++i)
        ImGui::TextUnformatted(session.shaders.log[i].c_str());
    if (session.shaders.log.size() > shown) ImGui::Text("and %zu more", session.shaders.log.size() - shown);
    widgets.dump().lastItem("shaders", session.shaders.log);
    endBox();
}

void drawLoading(const Session& session, Widgets& widgets, const Area& picture) {
    beginBox("loading", picture, {0.5f, 0.5f}, 520.0f * widgets.scale(), theme::accent);
    const std::string text = session.loading.text();
    ImGui::TextUnformatted(text.c_str());
    widgets.dump().lastItem("loading", text);
    ImGui::TextColored(theme::quiet, "Escape stops it.");
    endBox();
}

void drawNotice(const Session& session, Widgets& widgets, const Area& picture) {
    // A margin above the picture's lower edge.
    Area inside = picture;
    inside.size.y = std::max(1.0f, inside.size.y - 14.0f * widgets.scale());
    beginBox("notice", inside, {0.5f, 1.0f}, 520.0f * widgets.scale(),
             session.notices.current()->bad ? theme::bad : theme::accent);
    ImGui::TextUnformatted(session.notices.current()->text.c_str());
    widgets.dump().lastItem("notice", session.notices.current()->text);
    endBox();
}

/// Fills the row; left out where the picture behind has little room.
void drawPagePicture(Session& session, Widgets& widgets, const Area& picture, float width, const std::string& shown) {
    const std::string& name = session.technique.name();
    if (picture.size.y < 520.0f * widgets.scale() || picture.size.x < width + 60.0f) return;
    const gl::Texture* texture = session.pagePictures.of(name);
    if (texture == nullptr) return;
    ImGui::Image(imguiId(*texture),
                 {width, width * static_cast<float>(texture->height()) / static_cast<float>(texture->width())});
    widgets.dump().lastItem("page.picture", name);
    ImGui::TextColored(theme::quiet, "%s", shown.c_str());
    ImGui::Spacing();
}

void drawPage(Session& session, Widgets& widgets, const Area& picture) {
    const TechniqueDescription& technique = session.technique.current().description();
    const float width = 460.0f * widgets.scale();
    beginBox("page", picture, {0.5f, 0.5f}, width, ImGui::GetStyle().Colors[ImGuiCol_Border]);
    const auto paragraph = [](const char* heading, const std::string& text) {
        if (text.empty()) return;
        ImGui::TextColored(theme::accent, "%s", heading);
        ImGui::TextUnformatted(text.c_str());
        ImGui::Spacing();
    };
    paragraph(technique.title.c_str(), technique.summary);
    paragraph("From", technique.source);
    paragraph("What it gets wrong", technique.wrong);
    drawPagePicture(session, widgets, picture, width, technique.picture);
    paragraph("Look at", technique.look);
    std::string references;
    for (const std::string& reference : technique.references)
        references += (references.empty() ? "" : "\n") + reference;
    paragraph("References", references);
    widgets.dump().lastItem("page", technique.name);
    if (widgets.button("page.close", "Close")) session.panels.pageVisible = false;
    endBox();
}

void drawKeys(Session& session, Widgets& widgets, const Area& picture) {
    static constexpr std::array<std::array<const char*, 2>, 31> keys{
        {{"space", "play or pause"},
         {"left, right", "previous, next frame"},
         {", and .", "previous, next instant of the shutter"},
         {"Ctrl-R", "start or stop recording"},
         {"1 .. 9", "technique"},
         {"I", "about the technique"},
         {"V", "next view"},
         {"F", "hold: show B of a comparison"},
         {"X", "swap A/B of a comparison"},
         {"P", "save the picture"},
         {"Shift-P", "save it as EXR, in linear light"},
         {"M", "magnify the pixel under the mouse; lit values of its samples"},
         {"F5", "reload shaders"},
         {"? or F1", "show or hide this list"},
         {"H", "hide or show the panels"},
         {"R", "reset to the scene's camera"},
         {"drag", "orbit"},
         {"right-drag", "pan (or Shift and drag)"},
         {"wheel", "zoom"},
         {"double-click", "focus on what is under the mouse (or F, with no comparison)"},
         {"W A S D", "fly ahead, left, back, right; with Shift faster"},
         {"E, Q", "fly up, down"},
         {"Ctrl-drag", "move the light"},
         {"Ctrl-click", "type into a slider"},
         {"Ctrl-C", "copy the command line of this picture"},
         {"Ctrl-S", "save settings"},
         {"Ctrl-O", "load settings"},
         {"Ctrl-Z", "undo a setting"},
         {"Ctrl-Y", "redo it (or Ctrl-Shift-Z)"},
         {"Escape", "close what is on top, or leave its state"},
         {"Ctrl-Q", "quit"}}};
    beginBox("keys", picture, {0.5f, 0.5f}, 600.0f * widgets.scale(), ImGui::GetStyle().Colors[ImGuiCol_Border]);
    if (ImGui::BeginTable("keys", 2)) {
        for (const auto& [key, meaning] : keys) {
            ImGui::TableNextColumn();
            ImGui::TextColored(theme::accent, "%s  ", key);
            ImGui::TableNextColumn();
            ImGui::TextUnformatted(meaning);
        }
        ImGui::EndTable();
    }
    if (widgets.button("keys.close", "Close")) session.panels.keysVisible = false;
    endBox();
}

}  // namespace

void drawOverlays(Session& session, Widgets& widgets, const Area& picture) {
    const float least = 60.0f * widgets.scale();
    if (picture.size.x < least || picture.size.y < least) return;
    drawChips(session, widgets, picture);
    if (session.panels.storyVisible) drawStory(session, widgets, picture);
    if (session.driver.state() == FrameDriver::State::Failed) drawFailure(session, widgets, picture);
    if (!session.shaders.log.empty()) drawShaderLog(session, widgets, picture);
    drawProbe(session, widgets, picture);
    if (session.panels.pageVisible) drawPage(session, widgets, picture);
    if (session.panels.keysVisible) drawKeys(session, widgets, picture);
    if (session.loading.on()) drawLoading(session, widgets, picture);
    if (session.notices.current()) drawNotice(session, widgets, picture);
}

}  // namespace timeshade
