#include "contexts/back_ends.h"
#include "core/error.h"

#include <fmt/format.h>

namespace timeshade {
namespace {

constexpr int neededMajor = 4;
constexpr int neededMinor = 5;

std::string glString(PFNGLGETSTRINGPROC getString, GLenum name) {
    const GLubyte* text = getString != nullptr ? getString(name) : nullptr;
    return text != nullptr ? reinterpret_cast<const char*>(text) : "unknown";
}

}  // namespace

std::string describeTooOld(GLADloadfunc loader, std::string_view backEnd) {
    const auto getString = reinterpret_cast<PFNGLGETSTRINGPROC>(loader("glGetString"));
    return fmt::format("{}: found OpenGL {} (vendor {}, renderer {}), expected a {}.{} core context", backEnd,
                       glString(getString, GL_VERSION), glString(getString, GL_VENDOR),
                       glString(getString, GL_RENDERER), neededMajor, neededMinor);
}

void loadOpenGl(GLADloadfunc loader, std::string_view backEnd) {
    const int version = gladLoadGL(loader);
    if (version < GLAD_MAKE_VERSION(neededMajor, neededMinor)) {
        throw Error(describeTooOld(loader, backEnd));
    }
}

}  // namespace timeshade
