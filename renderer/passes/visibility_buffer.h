#pragma once

#include "gl/texture.h"

namespace timeshade {

/// `lit` of every camera sample, R32F, one layer per stratum: 1 lit, 0 shadowed, fractions where a technique filters
/// or integrates. By convention 1 where a sample sees nothing, and 0 where its surface faces away from the light or
/// lies outside the light's cone (no technique is asked there: lib/receiver.glsl).
class VisibilityBuffer {
  public:
    VisibilityBuffer(int width, int height, int strata)
        : lit_(gl::Texture::array2D("visibility", GL_R32F, width, height, strata)) {}
    const gl::Texture& lit() const { return lit_; }
    std::size_t bytes() const { return lit_.bytes(); }

  private:
    gl::Texture lit_;
};

}  // namespace timeshade
