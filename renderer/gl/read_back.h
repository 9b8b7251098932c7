#pragma once

#include <cstddef>
#include <vector>

#include "gl/buffer.h"
#include "gl/texture.h"
#include "gl/waits.h"

namespace timeshade::gl {

/// `count` elements of a buffer from `first` on, as the device holds them: waits for it.
template <typename T>
std::vector<T> readElements(const Buffer& buffer, std::size_t first, std::size_t count) {
    std::vector<T> elements(count);
    if (count == 0) return elements;
    countWait();
    glGetNamedBufferSubData(buffer.name(), static_cast<GLintptr>(first * sizeof(T)),
                            static_cast<GLsizeiptr>(count * sizeof(T)), elements.data());
    return elements;
}

/// The one at that place.
template <typename T>
T readElement(const Buffer& buffer, std::size_t place = 0) {
    return readElements<T>(buffer, place, 1).front();
}

/// All texels of a texture's first level, layer by layer, rows upwards, in that format: waits for the device. `type` is
/// what T consists of.
template <typename T>
std::vector<T> readTexture(const Texture& texture, GLenum format, GLenum type) {
    std::vector<T> values(texture.bytes() / sizeof(T));
    countWait();
    glGetTextureImage(texture.name(), 0, format, type, static_cast<GLsizei>(texture.bytes()), values.data());
    return values;
}

/// A part of one layer.
struct TexelBlock {
    int x = 0, y = 0, layer = 0, width = 1, height = 1;
};

/// The texels of that part, rows upwards, into `values`, which has room for them.
template <typename T>
void readTexels(const Texture& texture, const TexelBlock& block, GLenum format, GLenum type, std::vector<T>& values) {
    countWait();
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glGetTextureSubImage(texture.name(), 0, block.x, block.y, block.layer, block.width, block.height, 1, format, type,
                         static_cast<GLsizei>(values.size() * sizeof(T)), values.data());
}

}  // namespace timeshade::gl
