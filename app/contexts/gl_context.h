#pragma once

#include <memory>
#include <string>
#include <vector>

namespace timeshade {

enum class ContextKind { Auto, Window, Egl, OsMesa };

/// An OpenGL 4.5 core context that is current on the calling thread from construction to destruction, with its
/// functions loaded. Nothing is drawn into its default framebuffer except by the window.
class GlContext {
  public:
    virtual ~GlContext() = default;
    GlContext() = default;
    GlContext(const GlContext&) = delete;
    GlContext& operator=(const GlContext&) = delete;
    /// Which back end made it: "EGL surfaceless", "EGL device 0", "OSMesa", "GLFW".
    virtual std::string backEnd() const = 0;
};

struct ContextOptions {
    ContextKind kind = ContextKind::Auto;  ///< Auto: EGL, then OSMesa
    int device = -1;                       ///< index of an EGL device; -1: surfaceless first, then any device
    bool debug = false;                    ///< ask for a debug context, so that KHR_debug tells all it can
};

/// A context without a window. Needs no DISPLAY. Throws Error with one line that says what was tried and why each
/// failed (no library, no display, GL too old with the version found, ...).
std::unique_ptr<GlContext> makeHeadlessContext(const ContextOptions& options);

struct DeviceDescription {
    int index = 0;
    std::string name;  ///< what the EGL device says of itself, or its renderer string
};

/// The EGL devices of this machine; empty where EGL or its device extensions are missing.
std::vector<DeviceDescription> listDevices();

}  // namespace timeshade
