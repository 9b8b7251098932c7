#include "gl/device_info.h"

#include <algorithm>
#include <array>

#include <glad/gl.h>

namespace timeshade::gl {

namespace {
std::string text(GLenum which) {
    const GLubyte* value = glGetString(which);
    // glGetString returns unsigned bytes that are plain text.
    return value ? reinterpret_cast<const char*>(value) : "unknown";
}
}  // namespace

DeviceInfo currentDevice() {
    DeviceInfo info{text(GL_VENDOR), text(GL_RENDERER), text(GL_VERSION), false};
    const std::array<const char*, 4> software{"llvmpipe", "softpipe", "swrast", "SwiftShader"};
    info.software = std::any_of(software.begin(), software.end(),
                                [&](const char* name) { return info.renderer.find(name) != std::string::npos; });
    return info;
}

}  // namespace timeshade::gl
