#include "window/controls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#define GLFW_INCLUDE_NONE  // glad declares OpenGL
#include <GLFW/glfw3.h>
#include <imgui.h>

#include "techniques/registry.h"
#include "window/chips.h"
#include "window/seen_point.h"

namespace timeshade {

namespace {

/// As this version of ImGui numbers them: before 1.87, as GLFW does.
namespace keys {
#if IMGUI_VERSION_NUM >= 18700
constexpr ImGuiKey magnify = ImGuiKey_M, flip = ImGuiKey_F, ahead = ImGuiKey_W, back = ImGuiKey_S, left = ImGuiKey_A,
                   right = ImGuiKey_D, up = ImGuiKey_E, down = ImGuiKey_Q;
#else
constexpr int magnify = GLFW_KEY_M, flip = GLFW_KEY_F, ahead = GLFW_KEY_W, back = GLFW_KEY_S, left = GLFW_KEY_A,
              right = GLFW_KEY_D, up = GLFW_KEY_E, down = GLFW_KEY_Q;
#endif
}  // namespace keys

/// A key that flies, for GLFW and for ImGui, and where: right, up and ahead.
struct FlightKey {
    int pressed;
    decltype(keys::ahead) held;
    glm::dvec3 way;
};
const std::array<FlightKey, 6> flights{{{GLFW_KEY_D, keys::right, {1, 0, 0}},
                                        {GLFW_KEY_A, keys::left, {-1, 0, 0}},
                                        {GLFW_KEY_E, keys::up, {0, 1, 0}},
                                        {GLFW_KEY_Q, keys::down, {0, -1, 0}},
                                        {GLFW_KEY_W, keys::ahead, {0, 0, 1}},
                                        {GLFW_KEY_S, keys::back, {0, 0, -1}}}};
constexpr int commandMods = GLFW_MOD_CONTROL | GLFW_MOD_ALT | GLFW_MOD_SUPER;

constexpr double radiansPerHeight = 3.0;  // of a drag over the whole height of the picture
constexpr float seamReach = 8.0f;         // units of the window within which the seam is grasped
constexpr double zoomPerNotch = 0.88;
constexpr double flownPerSecond = 0.25;  // sizes of the scene
constexpr double longestFlight = 0.1;    // seconds of one step: a slow frame is no leap

/// From one of the comparing views back to the first.
void nextView(Session& session) {
    const std::vector<std::string> names = viewNames(session.technique.current());
    const auto now = std::find(names.begin(), names.end(), session.view.name());
    const bool last = now == names.end() || now + 1 == names.end() || session.view.diagnostic != Diagnostic::None;
    session.view.show(last ? names.front() : *(now + 1));
}

void applyKey(Session& session, int key) {
    if (key >= GLFW_KEY_1 && key <= GLFW_KEY_9) {
        const auto index = static_cast<std::size_t>(key - GLFW_KEY_1);
        if (index < techniqueDescriptions().size()) session.requests.technique = techniqueDescriptions()[index].name;
        return;
    }
    switch (key) {
    case GLFW_KEY_SPACE: session.moment.playback.play(!session.moment.playback.playing()); return;
    case GLFW_KEY_LEFT: session.moment.playback.step(-1); return;
    case GLFW_KEY_RIGHT: session.moment.playback.step(1); return;
    case GLFW_KEY_COMMA: session.moment.stepInstant(-1.0 / 16.0); return;
    case GLFW_KEY_PERIOD: session.moment.stepInstant(1.0 / 16.0); return;
    case GLFW_KEY_V: nextView(session); return;
    case GLFW_KEY_X: session.requests.swap = true; return;
    case GLFW_KEY_P: session.requests.screenshot = true; return;
    case GLFW_KEY_H: session.panels.visible = !session.panels.visible; return;
    case GLFW_KEY_R: session.camera.useSceneCamera(session.moment, session.moment.request.cameraIndex); return;
    case GLFW_KEY_I: session.panels.pageVisible = !session.panels.pageVisible; return;
    case GLFW_KEY_F5: session.requests.reload = true; return;
    case GLFW_KEY_F1: session.panels.keysVisible = !session.panels.keysVisible; return;
    default: return;
    }
}

void applyControlKey(Session& session, int key, bool shift) {
    const bool typing = ImGui::GetIO().WantTextInput;  // Ctrl-C is the field's then
    if (key == GLFW_KEY_Z && !typing) (shift ? session.requests.redo : session.requests.undo) = true;
    if (key == GLFW_KEY_Y && !typing) session.requests.redo = true;
    if (key == GLFW_KEY_R) session.requests.recording = true;
    if (key == GLFW_KEY_S) session.requests.save = true;
    if (key == GLFW_KEY_O) session.requests.load = session.panels.settingsPath;
    if (key == GLFW_KEY_C && !typing) session.requests.command = true;
}

}  // namespace

bool applyKeys(Session& session, const std::vector<KeyPress>& keys) {
    for (const KeyPress& press : keys) {
        if (press.key == GLFW_KEY_Q && (press.mods & GLFW_MOD_CONTROL) != 0) return true;
        if (press.key == GLFW_KEY_SLASH && (press.mods & GLFW_MOD_SHIFT) != 0 && !ImGui::GetIO().WantTextInput)
            session.panels.keysVisible = !session.panels.keysVisible;
        // A list or a field that is open is Dear ImGui's to close.
        const bool open = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId) || ImGui::GetIO().WantTextInput;
        if (press.key == GLFW_KEY_ESCAPE && !open) closeTopmost(session);
        if ((press.mods & GLFW_MOD_CONTROL) != 0)
            applyControlKey(session, press.key, (press.mods & GLFW_MOD_SHIFT) != 0);
        const bool typing = ImGui::GetIO().WantTextInput;
        if (!typing && press.key == GLFW_KEY_P && (press.mods & GLFW_MOD_SHIFT) != 0) session.requests.exr = true;
        if (!typing && (press.mods & commandMods) == 0) applyKey(session, press.key);
    }
    return false;
}

namespace {

/// Magnifies the pixel under the mouse; over the one that is magnified, or beside the picture, ends it.
void pickPixel(Session& session, const Area& picture) {
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const auto pixel = [](float at, float from, float size, int pixels) {
        return static_cast<int>(std::floor((at - from) / std::max(size, 1.0f) * static_cast<float>(pixels)));
    };
    const int x = pixel(mouse.x, picture.position.x, picture.size.x, session.moment.request.width),
              y = pixel(mouse.y, picture.position.y, picture.size.y, session.moment.request.height);
    const bool inside = x >= 0 && y >= 0 && x < session.moment.request.width && y < session.moment.request.height;
    if (!inside || (session.probe.on() && session.probe.x() == x && session.probe.y() == y))
        session.probe.clear();
    else
        session.probe.pick(x, y);
}

/// Puts what the mouse is over into the middle.
void focusUnderMouse(Session& session, const Area& picture) {
    if (!session.driver.hasPlan() || picture.size.x <= 0.0f || picture.size.y <= 0.0f) return;
    const ImVec2 mouse = ImGui::GetIO().MousePos;
    const double x = static_cast<double>((mouse.x - picture.position.x) / picture.size.x),
                 y = static_cast<double>((mouse.y - picture.position.y) / picture.size.y);
    if (x < 0.0 || x > 1.0 || y < 0.0 || y > 1.0) return;
    const double aspectRatio = static_cast<double>(picture.size.x) / static_cast<double>(picture.size.y);
    const CameraPose pose = session.camera.pose(session.scene.current(), session.moment);
    const auto point = seenPoint(*session.renderer.plan().mesh, pose, aspectRatio, x, y);
    if (!point) return session.notify("There is nothing under the mouse to focus on");
    session.camera.take(session.scene.current(), session.moment).focus(*point);
}

/// Around the scene's centre: to the right as seen from the camera, and up.
void moveLight(Session& session, double dx, double dy) {
    const Scene& scene = session.scene.current();
    LightChange& light = session.moment.request.light;
    LightDirection direction = light.direction.value_or(directionOf(lightAtOwnFrame(scene), scene.bounds().centre()));
    direction.azimuth = std::remainder(direction.azimuth + glm::degrees(radiansPerHeight) * dx, 360.0);
    direction.elevation = std::clamp(direction.elevation - glm::degrees(radiansPerHeight) * dy, -90.0, 90.0);
    light.direction = direction;
}

}  // namespace

void PictureMouse::press(const std::vector<KeyPress>& keys) {
    for (const KeyPress& press : keys)
        for (std::size_t i = 0; i < flights.size(); ++i)
            if (press.key == flights[i].pressed && !press.repeated) flightKeys_[i] = (press.mods & commandMods) == 0;
}

void PictureMouse::fly(Session& session) {
    const ImGuiIO& io = ImGui::GetIO();
    glm::dvec3 way(0.0);
    for (std::size_t i = 0; i < flights.size(); ++i) {
        flightKeys_[i] = flightKeys_[i] && ImGui::IsKeyDown(flights[i].held);
        if (flightKeys_[i]) way += flights[i].way;
    }
    const double seconds = std::clamp(session.now - std::exchange(flownUntil_, session.now), 0.0, longestFlight);
    flying_ = !io.WantTextInput && !io.KeyCtrl && !io.KeyAlt && way != glm::dvec3(0.0);
    if (!flying_) return;
    const double speed = flownPerSecond * (io.KeyShift ? 4.0 : 1.0);
    session.camera.take(session.scene.current(), session.moment).fly(speed * seconds * way);
}

void PictureMouse::apply(Session& session, const Area& picture) {
    const ImGuiIO& io = ImGui::GetIO();
    fly(session);
    if (!io.WantTextInput && ImGui::IsKeyPressed(keys::magnify, false)) pickPixel(session, picture);
    const bool down = io.MouseDown[0] || io.MouseDown[1] || io.MouseDown[2];
    Comparison& comparison = session.comparison;
    comparison.flipped = comparison.on() && !io.WantTextInput && ImGui::IsKeyDown(keys::flip);
    const bool pressed = ImGui::IsMouseClicked(0) || ImGui::IsMouseClicked(1) || ImGui::IsMouseClicked(2);
    const bool wiping =
        comparison.on() && comparison.mode == CompareMode::Wipe && !comparison.flip && picture.size.x > 0.0f;
    const auto seamX = picture.position.x + static_cast<float>(comparison.seam) * picture.size.x;
    const bool atSeam = wiping && !io.WantCaptureMouse && std::abs(io.MousePos.x - seamX) <= seamReach;
    const bool focusKey = !comparison.on() && !io.WantTextInput && ImGui::IsKeyPressed(keys::flip, false);
    if (focusKey || (ImGui::IsMouseDoubleClicked(0) && !io.WantCaptureMouse && !atSeam))
        focusUnderMouse(session, picture);
    if (atSeam || movingSeam_) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    if (ImGui::IsMouseClicked(0) && atSeam)
        movingSeam_ = true;
    else if (pressed && !io.WantCaptureMouse)
        dragging_ = true;
    if (pressed && dragging_) movingLight_ = io.KeyCtrl && ImGui::IsMouseClicked(0);
    if (!down) dragging_ = movingSeam_ = movingLight_ = false;
    if (movingSeam_)
        comparison.seam =
            std::clamp(static_cast<double>((io.MousePos.x - picture.position.x) / picture.size.x), 0.0, 1.0);
    const double height = std::max(1.0, static_cast<double>(picture.size.y));
    const double dx = static_cast<double>(io.MouseDelta.x) / height, dy = static_cast<double>(io.MouseDelta.y) / height;
    if (dragging_ && !pressed && (dx != 0.0 || dy != 0.0)) {
        if (movingLight_)
            moveLight(session, dx, dy);
        else if (io.MouseDown[0] && !io.KeyShift)
            session.camera.take(session.scene.current(), session.moment)
                .orbit(-radiansPerHeight * dx, radiansPerHeight * dy);
        else
            session.camera.take(session.scene.current(), session.moment).pan(-dx, dy);
    }
    if (io.MouseWheel != 0.0f && !io.WantCaptureMouse)
        session.camera.take(session.scene.current(), session.moment)
            .zoom(std::pow(zoomPerNotch, static_cast<double>(io.MouseWheel)));
}

}  // namespace timeshade
