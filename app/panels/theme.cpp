#include "panels/theme.h"

#include <algorithm>

namespace timeshade {

namespace {

void setColors(ImGuiStyle& style) {
    const auto set = [&](ImGuiCol index, float r, float g, float b, float a = 1.0f) {
        style.Colors[index] = {r, g, b, a};
    };
    style.Colors[ImGuiCol_Text] = theme::text;
    style.Colors[ImGuiCol_TextDisabled] = theme::quiet;
    set(ImGuiCol_WindowBg, 0.098f, 0.106f, 0.122f);
    set(ImGuiCol_PopupBg, 0.125f, 0.135f, 0.157f, 0.98f);
    set(ImGuiCol_Border, 0.20f, 0.22f, 0.25f);
    set(ImGuiCol_FrameBg, 0.165f, 0.180f, 0.208f);
    set(ImGuiCol_FrameBgHovered, 0.200f, 0.222f, 0.258f);
    set(ImGuiCol_FrameBgActive, 0.225f, 0.255f, 0.300f);
    set(ImGuiCol_Button, 0.190f, 0.210f, 0.245f);
    set(ImGuiCol_ButtonHovered, 0.240f, 0.280f, 0.335f);
    set(ImGuiCol_ButtonActive, 0.270f, 0.360f, 0.460f);
    set(ImGuiCol_Header, 0.140f, 0.152f, 0.176f);
    set(ImGuiCol_HeaderHovered, 0.190f, 0.212f, 0.250f);
    set(ImGuiCol_HeaderActive, 0.220f, 0.260f, 0.315f);
    set(ImGuiCol_Separator, 0.20f, 0.22f, 0.25f);
    set(ImGuiCol_SliderGrab, 0.27f, 0.43f, 0.60f);  // dark enough for the value written over it
    set(ImGuiCol_SliderGrabActive, 0.33f, 0.53f, 0.74f);
    style.Colors[ImGuiCol_CheckMark] = theme::accent;
    style.Colors[ImGuiCol_PlotHistogram] = theme::accent;
    set(ImGuiCol_ScrollbarBg, 0.098f, 0.106f, 0.122f, 0.0f);
    set(ImGuiCol_ScrollbarGrab, 0.24f, 0.26f, 0.30f);
    set(ImGuiCol_ScrollbarGrabHovered, 0.30f, 0.33f, 0.38f);
    set(ImGuiCol_ScrollbarGrabActive, 0.36f, 0.40f, 0.46f);
    set(ImGuiCol_TextSelectedBg, 0.26f, 0.45f, 0.64f, 0.6f);
}

}  // namespace

void applyTheme(float scale) {
    ImGuiStyle& style = ImGui::GetStyle();
    style = ImGuiStyle();
    style.WindowPadding = {12.0f, 10.0f};
    style.FramePadding = {7.0f, 4.0f};
    style.ItemSpacing = {7.0f, 6.0f};
    style.ItemInnerSpacing = {6.0f, 5.0f};
    style.IndentSpacing = 14.0f;
    style.ScrollbarSize = 11.0f;
    style.GrabMinSize = 11.0f;
    style.WindowBorderSize = 0.0f;
    style.PopupBorderSize = 1.0f;
    style.WindowRounding = 0.0f;
    style.FrameRounding = 4.0f;
    style.PopupRounding = 5.0f;
    style.GrabRounding = 3.0f;
    style.ScrollbarRounding = 6.0f;
    setColors(style);
    style.ScaleAllSizes(scale);
    // A window smaller than ImGui's idea of the least size must not push panels over its edge.
    style.WindowMinSize = {1.0f, 1.0f};
    // ImGui aborts where these have no extent.
    style.ScrollbarSize = std::max(style.ScrollbarSize, 1.0f);
    style.GrabMinSize = std::max(style.GrabMinSize, 1.0f);
}

}  // namespace timeshade
