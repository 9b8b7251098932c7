#pragma once

#include <cstddef>
#include <vector>

#include "gl/buffer.h"

namespace timeshade::gl {

/// `count` elements of a buffer from `first` on, as the device holds them: waits for it.
template <typename T>
std::vector<T> readElements(const Buffer& buffer, std::size_t first, std::size_t count) {
    std::vector<T> elements(count);
    if (count > 0)
        glGetNamedBufferSubData(buffer.name(), static_cast<GLintptr>(first * sizeof(T)),
                                static_cast<GLsizeiptr>(count * sizeof(T)), elements.data());
    return elements;
}

}  // namespace timeshade::gl
