#include "gl/debug_log.h"

#include <glad/gl.h>

#include "gl/errors.h"

namespace timeshade::gl {

namespace {
void GLAD_API_PTR onMessage(GLenum, GLenum type, GLuint, GLenum severity, GLsizei length, const GLchar* text,
                            const void* user) {
    const bool counts = type == GL_DEBUG_TYPE_ERROR || type == GL_DEBUG_TYPE_UNDEFINED_BEHAVIOR ||
                        type == GL_DEBUG_TYPE_DEPRECATED_BEHAVIOR;
    if (!counts || severity == GL_DEBUG_SEVERITY_NOTIFICATION) return;
    if (type == GL_DEBUG_TYPE_ERROR) noteDriverMessage(std::string(text, static_cast<std::size_t>(length)));
    // The API hands user pointers back as const.
    static_cast<DebugLog*>(const_cast<void*>(user))->add(std::string(text, static_cast<std::size_t>(length)));
}
}  // namespace

DebugLog::DebugLog() {
    glEnable(GL_DEBUG_OUTPUT);
    glEnable(GL_DEBUG_OUTPUT_SYNCHRONOUS);
    glDebugMessageCallback(&onMessage, this);
    glDebugMessageControl(GL_DONT_CARE, GL_DONT_CARE, GL_DONT_CARE, 0, nullptr, GL_TRUE);
}

DebugLog::~DebugLog() { glDebugMessageCallback(nullptr, nullptr); }

}  // namespace timeshade::gl
