#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "gl/object.h"

namespace timeshade::gl {

struct DeleteBuffer {
    void operator()(GLuint name) const { glDeleteBuffers(1, &name); }
};

/// A buffer of a fixed size. Holds at least one byte, so that an empty list can be bound like any other. Construction
/// throws LimitError, which ends in `advice`, where the device has no room for it.
class Buffer : public Object<DeleteBuffer> {
  public:
    Buffer(const std::string& labelText, std::size_t byteCount, const std::string& advice = "draw fewer triangles");

    template <typename T>
    Buffer(const std::string& labelText, std::span<const T> data) : Buffer(labelText, data.size_bytes()) {
        upload(data);
    }

    std::size_t bytes() const { return byteCount_; }

    /// Replaces the first data.size() elements. Asserts that they fit.
    template <typename T>
    void upload(std::span<const T> data) {
        uploadBytes(data.data(), data.size_bytes());
    }

  private:
    void uploadBytes(const void* data, std::size_t byteCount);
    std::size_t byteCount_ = 0;
};

}  // namespace timeshade::gl
