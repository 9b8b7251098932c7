#include "contexts/window_context.h"

#include <cstdlib>

#include "contexts/back_ends.h"
#include "core/error.h"

#define GLFW_INCLUDE_NONE  // glad declares OpenGL
#include <GLFW/glfw3.h>
#include <fmt/format.h>

namespace timeshade {
namespace {

/// What GLFW reported first since the last call of takeReason(): the cause, from which later reports follow.
std::string& firstReport() {
    static std::string text;
    return text;
}

void recordReport(int code, const char* description) {
    if (firstReport().empty()) {
        firstReport() = fmt::format("{} (GLFW error {:#x})", description, static_cast<unsigned>(code));
    }
}

std::string takeReason() {
    std::string text = firstReport().empty() ? "GLFW gave no reason" : firstReport();
    firstReport().clear();
    return text;
}

/// Without WAYLAND_DISPLAY, X11: GLFW 3.4 and later otherwise try Wayland first, whose library says on standard error
/// that there is none.
void choosePlatform() {
#ifdef GLFW_PLATFORM_X11
    const char* wayland = std::getenv("WAYLAND_DISPLAY");
    const bool none = wayland == nullptr || *wayland == '\0';
    const bool x11 = none && glfwPlatformSupported(GLFW_PLATFORM_X11) == GLFW_TRUE;
    glfwInitHint(GLFW_PLATFORM, x11 ? GLFW_PLATFORM_X11 : GLFW_ANY_PLATFORM);
#endif
}

void setHints(const WindowOptions& options) {
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, options.visible ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 4);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 5);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_DEBUG_CONTEXT, options.debug ? GLFW_TRUE : GLFW_FALSE);
}

/// Makes a hidden window with whatever context the driver has, only to name it in the message.
std::string whyRefused() {
    const std::string reason = takeReason();
    glfwDefaultWindowHints();
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    GLFWwindow* window = glfwCreateWindow(16, 16, "Timeshade", nullptr, nullptr);
    if (window == nullptr) {
        return fmt::format("no window can be opened: {}", reason);
    }
    glfwMakeContextCurrent(window);
    std::string text = describeTooOld(glfwGetProcAddress, "GLFW");
    glfwDestroyWindow(window);
    return text;
}

}  // namespace

WindowContext::WindowContext(const WindowOptions& options) {
    takeReason();
    glfwSetErrorCallback(recordReport);
    choosePlatform();
    if (glfwInit() != GLFW_TRUE) {
        throw Error(
            fmt::format("no window can be opened: {}; expected a display (DISPLAY or WAYLAND_DISPLAY). "
                        "Headless work: timeshade shot",
                        takeReason()));
    }
    try {
        setHints(options);
        window_ = glfwCreateWindow(options.width, options.height, options.title.c_str(), nullptr, nullptr);
        if (window_ == nullptr) {
            throw Error(whyRefused());
        }
        glfwMakeContextCurrent(window_);
        loadOpenGl(glfwGetProcAddress, backEnd());
    } catch (...) {
        glfwTerminate();
        throw;
    }
}

WindowContext::~WindowContext() {
    // Destroys the window as well; GLFW would otherwise keep the display open.
    glfwTerminate();
}

}  // namespace timeshade
