#pragma once

#include "contexts/gl_context.h"

#include <string>

struct GLFWwindow;

namespace timeshade {

/// What a window is made with. Sizes in screen coordinates; the framebuffer may be larger on a dense display.
struct WindowOptions {
    std::string title = "Timeshade";
    int width = 1280;
    int height = 720;
    bool visible = true;  ///< false: a window context for headless commands on a machine with a display
    bool debug = false;   ///< as ContextOptions::debug
};

/// A GLFW window and its OpenGL 4.5 core context, current on the calling thread, which must be the main one. One
/// at a time. Throws Error with one line: no display, OpenGL too old with the version found.
class WindowContext final : public GlContext {
  public:
    explicit WindowContext(const WindowOptions& options);
    ~WindowContext() override;

    std::string backEnd() const override { return "GLFW"; }
    /// Valid as long as this object; whoever draws the window swaps its buffers and polls its events.
    GLFWwindow* handle() const { return window_; }

  private:
    GLFWwindow* window_ = nullptr;
};

}  // namespace timeshade
