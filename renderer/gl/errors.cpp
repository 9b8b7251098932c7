#include "gl/errors.h"

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <glad/gl.h>

#include "core/error.h"

namespace timeshade::gl {

namespace {

/// A lost context reports an error for ever.
constexpr int mostReads = 100;

std::vector<std::string>& noted() {
    static std::vector<std::string> names;
    return names;
}

std::string& driverMessage() {
    static std::string text;
    return text;
}

std::string nameOf(GLenum code) {
    switch (code) {
    case GL_INVALID_ENUM: return "GL_INVALID_ENUM";
    case GL_INVALID_VALUE: return "GL_INVALID_VALUE";
    case GL_INVALID_OPERATION: return "GL_INVALID_OPERATION";
    case GL_INVALID_FRAMEBUFFER_OPERATION: return "GL_INVALID_FRAMEBUFFER_OPERATION";
    case GL_OUT_OF_MEMORY: return "GL_OUT_OF_MEMORY";
    case GL_CONTEXT_LOST: return "GL_CONTEXT_LOST";
    default: return fmt::format("error {:#06x}", code);
    }
}

}  // namespace

void collectErrors() {
    for (int i = 0; i < mostReads; ++i) {
        const GLenum code = glGetError();
        if (code == GL_NO_ERROR) return;
        const std::string name = nameOf(code);
        if (std::find(noted().begin(), noted().end(), name) == noted().end()) noted().push_back(name);
    }
}

std::string takeErrors() {
    collectErrors();
    const std::string names = fmt::format("{}", fmt::join(noted(), ", "));
    noted().clear();
    return names;
}

void requireNoErrors(const std::string& what) {
    const std::string names = takeErrors(), message = std::exchange(driverMessage(), "");
    if (names.empty()) return;
    throw Error(fmt::format("{}: the driver reports {} ({}): what it drew would be wrong", what, names,
                            message.empty() ? "--gl-debug names the call" : message));
}

void noteDriverMessage(const std::string& text) { driverMessage() = text; }

void requireAllocated(const std::string& label, std::size_t bytes, const std::string& advice) {
    const GLenum code = glGetError();
    if (code == GL_NO_ERROR) return;
    const double mebibytes = static_cast<double>(bytes) / (1024.0 * 1024.0);
    if (code == GL_OUT_OF_MEMORY)
        throw LimitError(fmt::format("not enough GPU memory for '{}' ({:.0f} MiB): {}", label, mebibytes, advice));
    throw LimitError(
        fmt::format("this device makes no '{}' of {:.0f} MiB ({}): {}", label, mebibytes, nameOf(code), advice));
}

void injectErrorForTest(const std::string& pass) {
    static const char* const wanted = std::getenv("TIMESHADE_TEST_GL_ERROR");
    if (wanted != nullptr && pass == wanted) glEnable(GL_INVALID_VALUE);
}

}  // namespace timeshade::gl
