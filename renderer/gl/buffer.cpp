#include "gl/buffer.h"

#include <algorithm>
#include <cassert>

#include "gl/errors.h"
#include "gl/uploads.h"

namespace timeshade::gl {

namespace {
GLuint createBuffer() {
    GLuint name = 0;
    glCreateBuffers(1, &name);
    return name;
}
}  // namespace

Buffer::Buffer(const std::string& labelText, std::size_t byteCount, const std::string& advice)
    : Object(createBuffer()), byteCount_(std::max<std::size_t>(byteCount, 16)) {
    label(GL_BUFFER, name(), labelText);
    collectErrors();
    glNamedBufferStorage(name(), static_cast<GLsizeiptr>(byteCount_), nullptr, GL_DYNAMIC_STORAGE_BIT);
    requireAllocated(labelText, byteCount_, advice);
}

void Buffer::uploadBytes(const void* data, std::size_t byteCount) {
    assert(byteCount <= byteCount_);
    gl::uploadBytes(name(), 0, {static_cast<const std::byte*>(data), byteCount});
}

}  // namespace timeshade::gl
