#include "gl/late_texels.h"

#include <cstring>
#include <limits>

#include "gl/errors.h"
#include "gl/waits.h"

namespace timeshade::gl {

namespace {

GLuint copyOf(const Texture& texture, GLenum format, GLenum type) {
    const auto bytes = static_cast<GLsizei>(texture.bytes());
    GLuint name = 0;
    glCreateBuffers(1, &name);
    label(GL_BUFFER, name, "texels to be read later");
    collectErrors();
    glNamedBufferStorage(name, bytes, nullptr, GL_MAP_READ_BIT | GL_CLIENT_STORAGE_BIT);
    requireAllocated("texels to be read later", texture.bytes(), "expected a smaller picture");
    glBindBuffer(GL_PIXEL_PACK_BUFFER, name);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureImage(texture.name(), 0, format, type, bytes, nullptr);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    return name;
}

}  // namespace

LateTexels::LateTexels(const Texture& texture, GLenum format, GLenum type)
    : Object(copyOf(texture, format, type)), bytes_(texture.bytes()) {}

void LateTexels::copyTo(void* values) {
    if (!copied_.passed()) {
        countWait();
        copied_.wait(std::numeric_limits<GLuint64>::max());
    }
    const void* memory = glMapNamedBufferRange(name(), 0, static_cast<GLsizeiptr>(bytes_), GL_MAP_READ_BIT);
    if (memory != nullptr) std::memcpy(values, memory, bytes_);
    glUnmapNamedBuffer(name());
    requireNoErrors("reading back what was drawn");
}

}  // namespace timeshade::gl
