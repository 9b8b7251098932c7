#include "gl/growing_buffer.h"

#include <algorithm>

#include <fmt/format.h>

#include "core/error.h"

namespace timeshade::gl {

namespace {

constexpr int smallRequestsBorne = 32;
constexpr std::size_t smallBuffer = 1 << 20;  // bytes; not worth giving back

double mebibytes(std::size_t bytes) { return static_cast<double>(bytes) / (1024.0 * 1024.0); }

std::size_t limitOf(GLenum name) {
    GLint64 value = 0;
    glGetInteger64v(name, &value);
    return static_cast<std::size_t>(std::max<GLint64>(value, 0));
}

}  // namespace

GrowingBuffer::GrowingBuffer(std::string labelText, GLenum texelFormat)
    : label_(std::move(labelText)), format_(texelFormat) {}

bool GrowingBuffer::isFarTooLarge(std::size_t elements) {
    const std::size_t held = buffer_->bytes();
    if (held <= smallBuffer || elements * bytesPerTexel(format_) >= held / 4) {
        smallRequests_ = 0;
        maxLately_ = 0;
        return false;
    }
    maxLately_ = std::max(maxLately_, elements);
    return ++smallRequests_ >= smallRequestsBorne;
}

std::size_t GrowingBuffer::capacity() const { return bytes() / bytesPerTexel(format_); }

void GrowingBuffer::reserve(std::size_t elements, const std::string& advice) {
    const std::size_t each = bytesPerTexel(format_);
    if (buffer_ && isFarTooLarge(elements))
        elements = maxLately_;
    else if (buffer_ && buffer_->bytes() >= elements * each)
        return;
    smallRequests_ = 0;
    maxLately_ = 0;
    const std::size_t largestBlock = limitOf(GL_MAX_SHADER_STORAGE_BLOCK_SIZE),
                      maxTexels = limitOf(GL_MAX_TEXTURE_BUFFER_SIZE);
    if (elements * each > largestBlock)
        throw LimitError(fmt::format(
            "'{}' needs {:.0f} MiB for {} entries; this device's GL_MAX_SHADER_STORAGE_BLOCK_SIZE is {:.0f} MiB: {}",
            label_, mebibytes(elements * each), elements, mebibytes(largestBlock), advice));
    if (elements > maxTexels)
        throw LimitError(fmt::format("'{}' needs {} entries; this device's GL_MAX_TEXTURE_BUFFER_SIZE is {}: {}",
                                     label_, elements, maxTexels, advice));
    const std::size_t room = std::min({elements + elements / 32, largestBlock / each, maxTexels});
    view_.reset();
    buffer_.reset();  // first, so that both need not fit at once
    buffer_.emplace(label_, room * each, advice);
    view_ = Texture::ofBuffer(label_, format_, *buffer_);
}

}  // namespace timeshade::gl
