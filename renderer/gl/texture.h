#pragma once

#include <cstddef>
#include <string>

#include "gl/buffer.h"
#include "gl/object.h"

namespace timeshade::gl {

struct DeleteTexture {
    void operator()(GLuint name) const { glDeleteTextures(1, &name); }
};

/// A texture of immutable storage, NEAREST and clamped to its edge until told otherwise (an integer texture with any
/// other filter is incomplete and reads as zero).
class Texture : public Object<DeleteTexture> {
  public:
    /// A 2D array of `layers` layers, each width x height. All at least 1. Throws Error where the memory can't be had.
    static Texture array2D(const std::string& labelText, GLenum internalFormat, int width, int height, int layers,
                           int levels = 1);
    static Texture image2D(const std::string& labelText, GLenum internalFormat, int width, int height, int levels = 1);
    /// A view of a whole buffer as texels of `internalFormat`; the buffer must outlive it.
    static Texture ofBuffer(const std::string& labelText, GLenum internalFormat, const Buffer& buffer);

    int width() const { return width_; }
    int height() const { return height_; }
    int layers() const { return layers_; }
    bool isArray() const { return isArray_; }
    GLenum format() const { return format_; }     ///< the internal format
    std::size_t bytes() const { return bytes_; }  ///< 0 for a buffer's view: the buffer counts them

    void bind(GLuint unit) const { glBindTextureUnit(unit, name()); }
    void setFilters(GLenum minification, GLenum magnification) const;
    void setWrap(GLenum mode) const;

  private:
    Texture(GLenum target, const std::string& labelText);
    int width_ = 0, height_ = 0, layers_ = 0;
    bool isArray_ = false;
    GLenum format_ = 0;
    std::size_t bytes_ = 0;
};

/// Bytes of one texel of the formats that this program uses.
std::size_t bytesPerTexel(GLenum internalFormat);

}  // namespace timeshade::gl
