#pragma once

#include <string>
#include <vector>

#include "window/mouse_queue.h"

struct GLFWwindow;

namespace timeshade {

struct KeyPress {
    int key = 0;            ///< GLFW_KEY_...
    int mods = 0;           ///< GLFW_MOD_...
    bool repeated = false;  ///< it has been held for a while
};

/// What has happened to the window since the last look. Keys and the mouse's doings are kept in order, so that none is
/// lost while a frame takes long. Made before ImGui hooks into the window: ImGui passes on what it hears.
class WindowEvents {
  public:
    explicit WindowEvents(GLFWwindow* window);
    ~WindowEvents();
    WindowEvents(const WindowEvents&) = delete;
    WindowEvents& operator=(const WindowEvents&) = delete;

    /// True once after anything happened.
    bool takeActivity();
    const std::vector<KeyPress>& keys() const { return keys_; }
    std::vector<KeyPress> takeKeys();
    MouseQueue& mouse() { return mouse_; }
    /// Paths of files dropped on the window.
    std::vector<std::string> takeDropped();

  private:
    static WindowEvents& of(GLFWwindow* window);

    GLFWwindow* window_;
    bool activity_ = true;
    std::vector<KeyPress> keys_;
    MouseQueue mouse_;
    std::vector<std::string> dropped_;
};

}  // namespace timeshade
