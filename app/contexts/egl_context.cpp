#include "contexts/back_ends.h"
#include "core/error.h"

#define EGL_NO_X11  // headless code must not need X11's headers
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <utility>

namespace timeshade {
namespace {

template <class Function>
Function eglFunction(const char* name) {
    return reinterpret_cast<Function>(eglGetProcAddress(name));
}

bool hasExtension(const char* extensions, std::string_view name) {
    // Whole words only: some extension names are the beginning of others.
    const std::string list = fmt::format(" {} ", extensions != nullptr ? extensions : "");
    return list.find(fmt::format(" {} ", name)) != std::string::npos;
}

bool hasClientExtension(std::string_view name) {
    return hasExtension(eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS), name);
}

std::string eglErrorName() {
    const EGLint code = eglGetError();
    switch (code) {
    case EGL_SUCCESS: return "no reason given";
    case EGL_NOT_INITIALIZED: return "EGL_NOT_INITIALIZED";
    case EGL_BAD_ACCESS: return "EGL_BAD_ACCESS";
    case EGL_BAD_ALLOC: return "EGL_BAD_ALLOC";
    case EGL_BAD_ATTRIBUTE: return "EGL_BAD_ATTRIBUTE";
    case EGL_BAD_CONFIG: return "EGL_BAD_CONFIG";
    case EGL_BAD_DISPLAY: return "EGL_BAD_DISPLAY";
    case EGL_BAD_MATCH: return "EGL_BAD_MATCH";
    case EGL_BAD_PARAMETER: return "EGL_BAD_PARAMETER";
    case EGL_BAD_DEVICE_EXT: return "EGL_BAD_DEVICE_EXT";
    default: return fmt::format("EGL error {:#06x}", code);
    }
}

/// Where a context may be made: a display that is not initialised yet, and the back end's name.
struct Place {
    EGLDisplay display = EGL_NO_DISPLAY;
    std::string name;
};

EGLDisplay platformDisplay(EGLenum platform, void* native) {
    const auto get = eglFunction<PFNEGLGETPLATFORMDISPLAYEXTPROC>("eglGetPlatformDisplayEXT");
    return get != nullptr ? get(platform, native, nullptr) : EGL_NO_DISPLAY;
}

std::vector<EGLDeviceEXT> queryDevices() {
    // The base extension is the older name of enumeration and query together.
    const bool enumerates =
        hasClientExtension("EGL_EXT_device_enumeration") || hasClientExtension("EGL_EXT_device_base");
    if (!enumerates || !hasClientExtension("EGL_EXT_platform_device")) {
        return {};
    }
    const auto query = eglFunction<PFNEGLQUERYDEVICESEXTPROC>("eglQueryDevicesEXT");
    EGLint count = 0;
    if (query == nullptr || query(0, nullptr, &count) != EGL_TRUE || count <= 0) {
        return {};
    }
    std::vector<EGLDeviceEXT> devices(static_cast<std::size_t>(count));
    if (query(count, devices.data(), &count) != EGL_TRUE) {
        return {};
    }
    devices.resize(static_cast<std::size_t>(count));
    return devices;
}

const char* deviceString(EGLDeviceEXT device, EGLint name) {
    const auto query = eglFunction<PFNEGLQUERYDEVICESTRINGEXTPROC>("eglQueryDeviceStringEXT");
    return query != nullptr ? query(device, name) : nullptr;
}

bool isSoftwareDevice(EGLDeviceEXT device) {
    return hasExtension(deviceString(device, EGL_EXTENSIONS), "EGL_MESA_device_software");
}

Place devicePlace(const std::vector<EGLDeviceEXT>& devices, std::size_t index) {
    return {platformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[index]), fmt::format("EGL device {}", index)};
}

/// Chooses a configuration only where contexts cannot do without one.
EGLConfig contextConfig(EGLDisplay display) {
    if (hasExtension(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) {
        return EGL_NO_CONFIG_KHR;
    }
    const std::array<EGLint, 5> wanted = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE,
                                          EGL_NONE};
    EGLConfig config = EGL_NO_CONFIG_KHR;
    EGLint count = 0;
    eglChooseConfig(display, wanted.data(), &config, 1, &count);
    return count > 0 ? config : EGL_NO_CONFIG_KHR;
}

class EglContext final : public GlContext {
  public:
    EglContext(Place place, bool debug) : place_(std::move(place)) {
        initialiseDisplay();
        const EGLConfig config = contextConfig(place_.display);
        context_ = createContext(config, debug);
        if (context_ == EGL_NO_CONTEXT) {
            throw Error(whyRefused(config));
        }
        try {
            makeCurrent();
            loadOpenGl(eglGetProcAddress, place_.name);
        } catch (...) {
            destroy();
            throw;
        }
    }

    ~EglContext() override { destroy(); }

    std::string backEnd() const override { return place_.name; }

  private:
    void initialiseDisplay() const {
        // Never terminated: EGL hands the same display to everyone in the process and does not count its users;
        // it frees it at exit.
        if (place_.display == EGL_NO_DISPLAY || eglInitialize(place_.display, nullptr, nullptr) != EGL_TRUE) {
            throw Error(fmt::format("{}: no display: {}", place_.name, eglErrorName()));
        }
        if (eglBindAPI(EGL_OPENGL_API) != EGL_TRUE) {
            throw Error(fmt::format("{}: no desktop OpenGL: {}", place_.name, eglErrorName()));
        }
    }

    EGLContext createContext(EGLConfig config, bool debug) const {
        const std::array<EGLint, 9> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                  4,
                                                  EGL_CONTEXT_MINOR_VERSION,
                                                  5,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                  EGL_CONTEXT_OPENGL_DEBUG,
                                                  debug ? EGL_TRUE : EGL_FALSE,
                                                  EGL_NONE};
        return eglCreateContext(place_.display, config, EGL_NO_CONTEXT, attributes.data());
    }

    void makeCurrent() const {
        if (eglMakeCurrent(place_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) != EGL_TRUE) {
            throw Error(fmt::format("{}: the context cannot be made current without a surface: {}", place_.name,
                                    eglErrorName()));
        }
    }

    /// Makes whatever context the driver has, only to name it in the message.
    std::string whyRefused(EGLConfig config) {
        const std::string reason = eglErrorName();
        context_ = eglCreateContext(place_.display, config, EGL_NO_CONTEXT, nullptr);
        std::string text = fmt::format("{}: no OpenGL 4.5 core context: {}", place_.name, reason);
        if (context_ != EGL_NO_CONTEXT &&
            eglMakeCurrent(place_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE) {
            text = describeTooOld(eglGetProcAddress, place_.name);
        }
        destroy();
        return text;
    }

    void destroy() {
        if (context_ == EGL_NO_CONTEXT) {
            return;
        }
        // Only if it is still ours: a context made later on this thread stays current.
        if (eglGetCurrentContext() == context_) {
            eglMakeCurrent(place_.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        }
        eglDestroyContext(place_.display, context_);
        context_ = EGL_NO_CONTEXT;
    }

    Place place_;
    EGLContext context_ = EGL_NO_CONTEXT;
};

std::string currentRenderer() { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

bool isSoftwareRenderer(std::string_view renderer) {
    const auto names = {"llvmpipe", "softpipe", "swrast", "SWR"};
    return std::any_of(names.begin(), names.end(),
                       [&](const char* name) { return renderer.find(name) != std::string_view::npos; });
}

/// Tries a place; where it fails, adds the reason to `reasons` and returns null.
std::unique_ptr<GlContext> tryPlace(Place place, bool debug, std::string& reasons) {
    try {
        return std::make_unique<EglContext>(std::move(place), debug);
    } catch (const Error& error) {
        reasons += fmt::format("{}{}", reasons.empty() ? "" : "; ", error.what());
        return nullptr;
    }
}

std::unique_ptr<GlContext> makeDeviceContext(int index, bool debug) {
    const std::vector<EGLDeviceEXT> devices = queryDevices();
    if (devices.empty()) {
        throw Error(fmt::format("EGL device {}: this machine's EGL lists no devices; leave --device out", index));
    }
    if (static_cast<std::size_t>(index) >= devices.size()) {
        throw Error(fmt::format("EGL device {}: no such device, expected 0 to {} (see timeshade list --devices)", index,
                                devices.size() - 1));
    }
    return std::make_unique<EglContext>(devicePlace(devices, static_cast<std::size_t>(index)), debug);
}

std::string rendererOf(const Place& place) {
    try {
        const EglContext context(place, false);
        return currentRenderer();
    } catch (const Error& error) {
        return fmt::format("unusable: {}", error.what());
    }
}

Place surfacelessPlace() {
    return {platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY), "EGL surfaceless"};
}

/// Only Mesa knows this platform; where another vendor drives the GPU it falls back to the CPU without a word.
std::unique_ptr<GlContext> makeSurfacelessContext(bool debug, std::string& reasons) {
    if (!hasClientExtension("EGL_MESA_platform_surfaceless")) {
        reasons = "EGL surfaceless: not offered by this machine's EGL";
        return nullptr;
    }
    return tryPlace(surfacelessPlace(), debug, reasons);
}

/// The first device that makes a context; with `hardwareOnly`, the first that draws on a GPU.
std::unique_ptr<GlContext> makeFirstDeviceContext(const std::vector<EGLDeviceEXT>& devices, bool hardwareOnly,
                                                  bool debug, std::string& reasons) {
    for (std::size_t index = 0; index < devices.size(); ++index) {
        if (hardwareOnly && isSoftwareDevice(devices[index])) {
            continue;
        }
        auto context = tryPlace(devicePlace(devices, index), debug, reasons);
        if (context != nullptr && !(hardwareOnly && isSoftwareRenderer(currentRenderer()))) {
            return context;
        }
    }
    return nullptr;
}

}  // namespace

std::unique_ptr<GlContext> makeEglContext(const ContextOptions& options) {
    if (options.device >= 0) {
        return makeDeviceContext(options.device, options.debug);
    }
    const std::vector<EGLDeviceEXT> devices = queryDevices();
    std::string reasons;
    if (auto context = makeSurfacelessContext(options.debug, reasons)) {
        const bool hasHardware = !std::all_of(devices.begin(), devices.end(), isSoftwareDevice);
        if (!hasHardware || !isSoftwareRenderer(currentRenderer())) {
            return context;
        }
        context.reset();
        if (auto onGpu = makeFirstDeviceContext(devices, true, options.debug, reasons)) {
            return onGpu;
        }
        return std::make_unique<EglContext>(surfacelessPlace(), options.debug);
    }
    if (auto context = makeFirstDeviceContext(devices, false, options.debug, reasons)) {
        return context;
    }
    throw Error(fmt::format("{}{}", reasons, devices.empty() ? "; EGL devices: none" : ""));
}

std::vector<DeviceDescription> listDevices() {
    const std::vector<EGLDeviceEXT> devices = queryDevices();
    std::vector<DeviceDescription> descriptions;
    for (std::size_t index = 0; index < devices.size(); ++index) {
        descriptions.push_back({static_cast<int>(index), rendererOf(devicePlace(devices, index))});
    }
    return descriptions;
}

}  // namespace timeshade
