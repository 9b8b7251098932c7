#include "gl/uploads.h"

#include <atomic>

namespace timeshade::gl {

namespace {

std::atomic<std::uint64_t> uploaded{0};

}  // namespace

void uploadBytes(GLuint buffer, std::size_t from, std::span<const std::byte> data) {
    if (data.empty()) return;
    uploaded += data.size();
    glNamedBufferSubData(buffer, static_cast<GLintptr>(from), static_cast<GLsizeiptr>(data.size()), data.data());
}

std::uint64_t bytesUploadedSoFar() { return uploaded; }

}  // namespace timeshade::gl
