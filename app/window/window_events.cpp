#include "window/window_events.h"

#include <utility>

#define GLFW_INCLUDE_NONE  // glad declares OpenGL
#include <GLFW/glfw3.h>

namespace timeshade {

WindowEvents& WindowEvents::of(GLFWwindow* window) {
    return *static_cast<WindowEvents*>(glfwGetWindowUserPointer(window));
}

WindowEvents::WindowEvents(GLFWwindow* window) : window_(window) {
    glfwSetWindowUserPointer(window, this);
    double left = 0.0, top = 0.0;
    glfwGetCursorPos(window, &left, &top);
    mouse_.moved(left, top);
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
        of(w).activity_ = true;
        if (action != GLFW_RELEASE) of(w).keys_.push_back({key, mods, action == GLFW_REPEAT});
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned) { of(w).activity_ = true; });
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int) {
        of(w).activity_ = true;
        of(w).mouse_.pressed(button, action == GLFW_PRESS);
    });
    glfwSetScrollCallback(window, [](GLFWwindow* w, double, double) { of(w).activity_ = true; });
    glfwSetCursorPosCallback(window, [](GLFWwindow* w, double x, double y) {
        of(w).activity_ = true;
        of(w).mouse_.moved(x, y);
    });
    glfwSetCursorEnterCallback(window, [](GLFWwindow* w, int) { of(w).activity_ = true; });
    glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { of(w).activity_ = true; });
    glfwSetWindowIconifyCallback(window, [](GLFWwindow* w, int) { of(w).activity_ = true; });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { of(w).activity_ = true; });
    glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { of(w).activity_ = true; });
    glfwSetWindowContentScaleCallback(window, [](GLFWwindow* w, float, float) { of(w).activity_ = true; });
    glfwSetDropCallback(window, [](GLFWwindow* w, int count, const char** paths) {
        of(w).activity_ = true;
        for (int i = 0; i < count; ++i) of(w).dropped_.emplace_back(paths[i]);
    });
}

WindowEvents::~WindowEvents() {
    glfwSetKeyCallback(window_, nullptr);
    glfwSetCharCallback(window_, nullptr);
    glfwSetMouseButtonCallback(window_, nullptr);
    glfwSetScrollCallback(window_, nullptr);
    glfwSetCursorPosCallback(window_, nullptr);
    glfwSetCursorEnterCallback(window_, nullptr);
    glfwSetWindowFocusCallback(window_, nullptr);
    glfwSetWindowIconifyCallback(window_, nullptr);
    glfwSetWindowRefreshCallback(window_, nullptr);
    glfwSetFramebufferSizeCallback(window_, nullptr);
    glfwSetWindowContentScaleCallback(window_, nullptr);
    glfwSetDropCallback(window_, nullptr);
    glfwSetWindowUserPointer(window_, nullptr);
}

bool WindowEvents::takeActivity() { return std::exchange(activity_, false); }
std::vector<KeyPress> WindowEvents::takeKeys() { return std::exchange(keys_, {}); }
std::vector<std::string> WindowEvents::takeDropped() { return std::exchange(dropped_, {}); }

}  // namespace timeshade
