#include "gl/texture.h"

#include <cassert>

#include <fmt/format.h>

#include "core/error.h"
#include "gl/errors.h"

namespace timeshade::gl {

namespace {
GLuint createTexture(GLenum target) {
    GLuint name = 0;
    glCreateTextures(target, 1, &name);
    return name;
}

/// Reserves memory with `allocate`, and says what it was for where it can't be had.
template <typename Allocate>
void reserve(const std::string& labelText, std::size_t bytes, const Allocate& allocate) {
    collectErrors();
    allocate();
    requireAllocated(labelText, bytes, "expected a smaller picture, map or number of samples");
}

}  // namespace

Texture::Texture(GLenum target, const std::string& labelText) : Object(createTexture(target)) {
    label(GL_TEXTURE, name(), labelText);
    isArray_ = target == GL_TEXTURE_2D_ARRAY;
    if (target == GL_TEXTURE_BUFFER) return;
    setFilters(GL_NEAREST, GL_NEAREST);
    setWrap(GL_CLAMP_TO_EDGE);
}

Texture Texture::array2D(const std::string& labelText, GLenum internalFormat, int width, int height, int layers,
                         int levels) {
    assert(width > 0 && height > 0 && layers > 0 && levels > 0);
    Texture texture(GL_TEXTURE_2D_ARRAY, labelText);
    texture.format_ = internalFormat;
    texture.width_ = width;
    texture.height_ = height;
    texture.layers_ = layers;
    const std::size_t base = bytesPerTexel(internalFormat) * static_cast<std::size_t>(width) *
                             static_cast<std::size_t>(height) * static_cast<std::size_t>(layers);
    texture.bytes_ = levels > 1 ? base + base / 3 : base;
    reserve(labelText, texture.bytes_,
            [&] { glTextureStorage3D(texture.name(), levels, internalFormat, width, height, layers); });
    return texture;
}

Texture Texture::image2D(const std::string& labelText, GLenum internalFormat, int width, int height, int levels) {
    assert(width > 0 && height > 0 && levels > 0);
    Texture texture(GL_TEXTURE_2D, labelText);
    texture.format_ = internalFormat;
    texture.width_ = width;
    texture.height_ = height;
    texture.layers_ = 1;
    const std::size_t base =
        bytesPerTexel(internalFormat) * static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    texture.bytes_ = levels > 1 ? base + base / 3 : base;
    reserve(labelText, texture.bytes_,
            [&] { glTextureStorage2D(texture.name(), levels, internalFormat, width, height); });
    return texture;
}

Texture Texture::ofBuffer(const std::string& labelText, GLenum internalFormat, const Buffer& buffer) {
    GLint largest = 0;
    glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &largest);
    const std::size_t texels = buffer.bytes() / bytesPerTexel(internalFormat);
    if (texels > static_cast<std::size_t>(largest))
        throw LimitError(fmt::format(
            "'{}' has {} texels; this device's GL_MAX_TEXTURE_BUFFER_SIZE is {}: lower --map, or draw fewer "
            "triangles",
            labelText, texels, largest));
    Texture texture(GL_TEXTURE_BUFFER, labelText);
    glTextureBuffer(texture.name(), internalFormat, buffer.name());
    texture.format_ = internalFormat;
    return texture;
}

void Texture::setFilters(GLenum minification, GLenum magnification) const {
    glTextureParameteri(name(), GL_TEXTURE_MIN_FILTER, static_cast<GLint>(minification));
    glTextureParameteri(name(), GL_TEXTURE_MAG_FILTER, static_cast<GLint>(magnification));
}

void Texture::setWrap(GLenum mode) const {
    glTextureParameteri(name(), GL_TEXTURE_WRAP_S, static_cast<GLint>(mode));
    glTextureParameteri(name(), GL_TEXTURE_WRAP_T, static_cast<GLint>(mode));
}

std::size_t bytesPerTexel(GLenum internalFormat) {
    switch (internalFormat) {
    case GL_R8:
    case GL_R8UI: return 1;
    case GL_R32UI:
    case GL_R32F:
    case GL_RGBA8:
    case GL_SRGB8_ALPHA8:
    case GL_DEPTH_COMPONENT32F: return 4;
    case GL_RGBA16F:
    case GL_RG32UI:
    case GL_RG32F: return 8;
    case GL_RGBA32UI:
    case GL_RGBA32F: return 16;
    default: assert(false && "unknown format: add its size"); return 0;
    }
}

}  // namespace timeshade::gl
