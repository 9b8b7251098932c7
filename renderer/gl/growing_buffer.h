#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "gl/buffer.h"
#include "gl/texture.h"

namespace timeshade::gl {

/// A buffer that shaders write as a storage block and read through a buffer texture. It grows when more is asked of it,
/// and shrinks when for 32 requests in a row less than a quarter of it was asked for: one heavy scene does not hold its
/// memory for ever. What it held is lost in both cases, so that any reserve() may lose it.
class GrowingBuffer {
  public:
    /// `texelFormat`: one of the formats of bytesPerTexel; an element is one texel.
    GrowingBuffer(std::string labelText, GLenum texelFormat);

    /// Room for `elements`, and 3 % more when it is made anew. Throws LimitError where the device's storage blocks,
    /// buffer textures or memory do not take so many; the line names what was wanted, the limit, and `advice` ("lower
    /// --map").
    void reserve(std::size_t elements, const std::string& advice);

    void bindForWriting(GLuint binding) const { glBindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, buffer_->name()); }
    void bindForReading(GLuint unit) const { view_->bind(unit); }
    /// What is read of it, as a buffer texture; another one after each reserve().
    const Texture& texels() const { return *view_; }
    const Buffer& buffer() const { return *buffer_; }
    std::size_t bytes() const { return buffer_ ? buffer_->bytes() : 0; }
    /// Elements that it holds.
    std::size_t capacity() const;

  private:
    bool isFarTooLarge(std::size_t elements);

    std::string label_;
    GLenum format_;
    std::size_t maxLately_ = 0;  ///< elements asked for by the small requests in a row
    int smallRequests_ = 0;
    std::optional<Buffer> buffer_;
    std::optional<Texture> view_;
};

}  // namespace timeshade::gl
