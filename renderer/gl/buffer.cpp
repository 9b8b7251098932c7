#include "gl/buffer.h"

#include <algorithm>
#include <cassert>

namespace timeshade::gl {

namespace {
GLuint createBuffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return name;
}
}  // namespace

Buffer::Buffer(const std::string& labelText, std::size_t byteCount)
    : Object(createBuffer()), byteCount_(std::max<std::size_t>(byteCount, 16)) {
    label(GL_BUFFER, name(), labelText);
    glNamedBufferStorage(name(), static_cast<GLsizeiptr>(byteCount_), nullptr, GL_DYNAMIC_STORAGE_BIT);
}

void Buffer::uploadBytes(const void* data, std::size_t byteCount) {
    assert(byteCount <= byteCount_);
    if (byteCount > 0) glNamedBufferSubData(name(), 0, static_cast<GLsizeiptr>(byteCount), data);
}

}  // namespace timeshade::gl
