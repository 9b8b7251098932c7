#include "window/ui_window.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include <glad/gl.h>
#define GLFW_INCLUDE_NONE  // glad declares OpenGL
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

#include "core/font_file.h"
#include "panels/theme.h"

namespace timeshade {

namespace {

constexpr float fontHeight = 15.0f;  // pixels on a display of ordinary density

/// What the display asks for, or TIMESHADE_UI_SCALE where that is set.
float displayScale(GLFWwindow* window) {
    if (const char* text = std::getenv("TIMESHADE_UI_SCALE")) {
        char* end = nullptr;
        const float forced = std::strtof(text, &end);
        if (end != text && *end == '\0' && std::isfinite(forced) && forced > 0.0f)
            return std::clamp(forced, 0.5f, 4.0f);
    }
    float x = 1.0f, y = 1.0f;
    glfwGetWindowContentScale(window, &x, &y);
    const float scale = std::max(x, y);
    return std::isfinite(scale) && scale > 0.0f ? std::clamp(scale, 0.75f, 4.0f) : 1.0f;
}

/// Where the framebuffer is denser than the window's coordinates (macOS, Wayland), the display's scale is already in
/// it. The two sizes are asked for one after the other: while the window is being resized they need not belong
/// together.
float framebufferScale(GLFWwindow* window, float before) {
    int width = 0, height = 0, pixelWidth = 0, pixelHeight = 0;
    glfwGetWindowSize(window, &width, &height);
    glfwGetFramebufferSize(window, &pixelWidth, &pixelHeight);
    if (width <= 0 || height <= 0 || pixelWidth <= 0 || pixelHeight <= 0) return before;
    const float x = static_cast<float>(pixelWidth) / static_cast<float>(width);
    const float y = static_cast<float>(pixelHeight) / static_cast<float>(height);
    const bool plausible = x >= 0.5f && x <= 4.0f && std::abs(x - y) <= 0.05f * x;
    return plausible ? x : before;
}

}  // namespace

UiWindow::UiWindow(GLFWwindow* window) : window_(window), events_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    ImGui_ImplGlfw_InitForOpenGL(window, true);
    ImGui_ImplOpenGL3_Init("#version 450 core");
    glfwSwapInterval(1);
}

UiWindow::~UiWindow() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void UiWindow::rebuildFonts() {
    static constexpr std::array<ImWchar, 13> ranges{0x20,   0x24f,  0x370,  0x3ff,  0x400,  0x52f, 0x2010,
                                                    0x205e, 0x2190, 0x21ff, 0x25a0, 0x25ff, 0};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    std::error_code ignored;
    const std::string textFont = fontFile("DejaVuSans.ttf").string();
    const bool text = std::filesystem::exists(textFont, ignored) &&
                      atlas.AddFontFromFileTTF(textFont.c_str(), fontPixels_, nullptr, ranges.data()) != nullptr;
    if (text) {
        atlas.AddFontFromFileTTF(textFont.c_str(), std::round(1.4f * fontPixels_));  // the last one is the title's
    } else {
        ImFontConfig config;
        config.SizePixels = std::round(fontPixels_ * 13.0f / fontHeight);
        atlas.AddFontDefault(&config);
    }
#if IMGUI_VERSION_NUM < 19200  // later ones keep the atlas' texture up to date by themselves
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
#endif
}

void UiWindow::scaleFonts() {
#if IMGUI_VERSION_NUM >= 19200
    ImGui::GetStyle().FontSizeBase = fontPixels_;
    ImGui::GetStyle().FontScaleMain = 1.0f / pixelsPerUnit_;
#else
    ImGui::GetIO().FontGlobalScale = 1.0f / pixelsPerUnit_;
#endif
}

#if IMGUI_VERSION_NUM >= 18700

// ImGui has queues of its own: a key or a button that is pressed and let go in one slow frame stays so for a frame.
void UiWindow::holdShortPresses() {}
void UiWindow::replayMouse() { events_.mouse().next(); }

#else

/// ImGui looks at the keys once a frame, and would miss one that is pressed and let go while a slow frame is drawn.
void UiWindow::holdShortPresses() {
    ImGuiIO& io = ImGui::GetIO();
    for (const int key : heldKeys_) io.KeysDown[key] = glfwGetKey(window_, key) == GLFW_PRESS;
    heldKeys_.clear();
    for (const KeyPress& press : events_.keys()) {
        if (press.key < 0 || press.key > GLFW_KEY_LAST) continue;
        io.KeysDown[press.key] = true;
        heldKeys_.push_back(press.key);
    }
}

/// The back end asks the display where the mouse is now, which may be far from where a button went down.
void UiWindow::replayMouse() {
    ImGuiIO& io = ImGui::GetIO();
    const MouseState mouse = events_.mouse().next();
    if (ImGui::IsMousePosValid(&io.MousePos)) io.MousePos = {static_cast<float>(mouse.x), static_cast<float>(mouse.y)};
    std::copy(mouse.down.begin(), mouse.down.end(), io.MouseDown);
}

#endif

void UiWindow::beginFrame(double textScale) {
    const float wanted = displayScale(window_) * static_cast<float>(textScale);
    pixelsPerUnit_ = framebufferScale(window_, pixelsPerUnit_);
    const float layoutScale = wanted / pixelsPerUnit_;
    const float fontPixels = std::round(fontHeight * wanted);
    if (fontPixels != fontPixels_) {
        fontPixels_ = fontPixels;
        rebuildFonts();
    }
    if (layoutScale != layoutScale_) {
        layoutScale_ = layoutScale;
        applyTheme(layoutScale_);
    }
    scaleFonts();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    holdShortPresses();
    replayMouse();
    ImGui::NewFrame();
}

void UiWindow::growBy(int pixelsWide, int pixelsHigh) {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    const auto units = [&](int pixels) {
        return static_cast<int>(std::lround(static_cast<float>(pixels) / pixelsPerUnit_));
    };
    glfwSetWindowSize(window_, std::max(1, width + units(pixelsWide)), std::max(1, height + units(pixelsHigh)));
}

void UiWindow::endFrame() {
    ImGui::Render();
    int width = 0, height = 0;
    glfwGetFramebufferSize(window_, &width, &height);
    // The renderer leaves its own framebuffer, viewport and clip volume behind.
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_FRAMEBUFFER_SRGB);  // the picture is encoded already
    glViewport(0, 0, width, height);
    const ImVec4 background = theme::canvas;
    glClearColor(background.x, background.y, background.z, 1.0f);
    glClear(GL_COLOR_BUFFER_BIT);
    glUseProgram(0);  // the one in use may have been dropped; ImGui would bring it back
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
    glfwSwapBuffers(window_);
}

}  // namespace timeshade
