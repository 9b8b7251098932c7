#include "contexts/back_ends.h"
#include "core/error.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <array>

namespace timeshade {
namespace {

// OSMesa's interface, in our own words: newer Mesa releases ship neither the library nor its header, and a machine
// without them must still build and run everything else. Values from Mesa's GL/osmesa.h.
using OsMesaHandle = void*;
constexpr int osMesaFormat = 0x22;
constexpr int osMesaDepthBits = 0x30;
constexpr int osMesaProfile = 0x33;
constexpr int osMesaCoreProfile = 0x34;
constexpr int osMesaMajorVersion = 0x36;
constexpr int osMesaMinorVersion = 0x37;

struct OsMesaLibrary {
    OsMesaHandle (*createContextAttribs)(const int* attributes, OsMesaHandle shared) = nullptr;
    GLboolean (*makeCurrent)(OsMesaHandle context, void* buffer, GLenum type, GLsizei width, GLsizei height) = nullptr;
    OsMesaHandle (*getCurrentContext)() = nullptr;
    void (*destroyContext)(OsMesaHandle context) = nullptr;
    GLADapiproc (*getProcAddress)(const char* name) = nullptr;
};

template <class Function>
void bindSymbol(void* library, const char* name, Function& function) {
    function = reinterpret_cast<Function>(dlsym(library, name));
    if (function == nullptr) {
        throw Error(fmt::format("OSMesa: the library found has no {}, expected Mesa 12 or newer", name));
    }
}

void* openLibrary() {
    std::string firstReason;
    for (const char* name : {"libOSMesa.so.8", "libOSMesa.so.6", "libOSMesa.so"}) {
        if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
            return library;
        }
        const char* reason = dlerror();
        if (firstReason.empty() && reason != nullptr) {
            firstReason = reason;
        }
    }
    throw Error(fmt::format("OSMesa: {}", firstReason));
}

/// Opened once and never closed: the drivers inside register exit handlers that must stay mapped.
const OsMesaLibrary& osMesa() {
    static const OsMesaLibrary library = [] {
        void* handle = openLibrary();
        OsMesaLibrary functions;
        bindSymbol(handle, "OSMesaCreateContextAttribs", functions.createContextAttribs);
        bindSymbol(handle, "OSMesaMakeCurrent", functions.makeCurrent);
        bindSymbol(handle, "OSMesaGetCurrentContext", functions.getCurrentContext);
        bindSymbol(handle, "OSMesaDestroyContext", functions.destroyContext);
        bindSymbol(handle, "OSMesaGetProcAddress", functions.getProcAddress);
        return functions;
    }();
    return library;
}

class OsMesaContext final : public GlContext {
  public:
    OsMesaContext() {
        const std::array<int, 11> attributes = {osMesaFormat,
                                                GL_RGBA,
                                                osMesaDepthBits,
                                                24,
                                                osMesaProfile,
                                                osMesaCoreProfile,
                                                osMesaMajorVersion,
                                                4,
                                                osMesaMinorVersion,
                                                5,
                                                0};
        context_ = osMesa().createContextAttribs(attributes.data(), nullptr);
        if (context_ == nullptr) {
            throw Error(whyRefused());
        }
        try {
            if (!makeCurrent()) {
                throw Error("OSMesa: the context cannot be made current");
            }
            loadOpenGl(osMesa().getProcAddress, backEnd());
        } catch (...) {
            destroy();
            throw;
        }
    }

    ~OsMesaContext() override { destroy(); }

    std::string backEnd() const override { return "OSMesa"; }

  private:
    bool makeCurrent() {
        return osMesa().makeCurrent(context_, buffer_.data(), GL_UNSIGNED_BYTE, side, side) == GL_TRUE;
    }

    /// Makes whatever context the library has, only to name it in the message.
    std::string whyRefused() {
        const std::array<int, 3> attributes = {osMesaFormat, GL_RGBA, 0};
        context_ = osMesa().createContextAttribs(attributes.data(), nullptr);
        std::string text = "OSMesa: no OpenGL 4.5 core context";
        if (context_ != nullptr && makeCurrent()) {
            text = describeTooOld(osMesa().getProcAddress, backEnd());
        }
        destroy();
        return text;
    }

    void destroy() {
        if (context_ == nullptr) {
            return;
        }
        // Only if it is still ours: a context made later on this thread stays current.
        if (osMesa().getCurrentContext() == context_) {
            osMesa().makeCurrent(nullptr, nullptr, GL_UNSIGNED_BYTE, 0, 0);
        }
        osMesa().destroyContext(context_);
        context_ = nullptr;
    }

    // OSMesa wants memory for a default framebuffer; nothing is drawn into it.
    static constexpr int side = 16;
    std::array<GLubyte, static_cast<std::size_t>(side) * side * 4> buffer_{};
    OsMesaHandle context_ = nullptr;
};

}  // namespace

std::unique_ptr<GlContext> makeOsMesaContext(const ContextOptions& options) {
    if (options.device >= 0) {
        throw UsageError(
            fmt::format("OSMesa: has no devices, found --device {}; expected --context egl", options.device));
    }
    // options.debug changes nothing: OSMesa has no such attribute, and Mesa reports through KHR_debug anyway once
    // GL_DEBUG_OUTPUT is enabled.
    return std::make_unique<OsMesaContext>();
}

}  // namespace timeshade
