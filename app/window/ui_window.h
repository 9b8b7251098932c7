#pragma once

#include "window/window_events.h"

struct GLFWwindow;

namespace timeshade {

/// Dear ImGui in a GLFW window: its life, its text at the display's density, and its frames.
class UiWindow {
  public:
    explicit UiWindow(GLFWwindow* window);
    ~UiWindow();
    UiWindow(const UiWindow&) = delete;
    UiWindow& operator=(const UiWindow&) = delete;

    /// Makes the window larger, or smaller, by so many pixels.
    void growBy(int pixelsWide, int pixelsHigh);
    WindowEvents& events() { return events_; }
    /// Starts a frame. `textScale` is the user's wish, on top of the display's scale.
    void beginFrame(double textScale);
    /// Draws the frame into the window and shows it.
    void endFrame();

    /// Multiplies all lengths of the layout.
    float scale() const { return layoutScale_; }
    /// Pixels of the framebuffer per unit of the layout.
    float pixelsPerUnit() const { return pixelsPerUnit_; }

  private:
    void rebuildFonts();
    void scaleFonts();
    void holdShortPresses();
    void replayMouse();

    GLFWwindow* window_;
    WindowEvents events_;
    float layoutScale_ = 0.0f;
    float pixelsPerUnit_ = 1.0f;
    float fontPixels_ = 0.0f;
    std::vector<int> heldKeys_;  ///< shown to ImGui as down for a frame, whatever has become of them since
};

}  // namespace timeshade
