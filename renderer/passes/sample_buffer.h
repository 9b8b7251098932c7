#pragma once

#include "gl/texture.h"

namespace timeshade {

/// What every camera sample sees: the number of a triangle, or NO_TRIANGLE. One layer per stratum of the shutter,
/// R32UI. Position, normals and material follow from the number and the sample's time (lib/receiver.glsl).
class SampleBuffer {
  public:
    SampleBuffer(int width, int height, int strata)
        : ids_(gl::Texture::array2D("sample ids", GL_R32UI, width, height, strata)) {}
    const gl::Texture& ids() const { return ids_; }
    std::size_t bytes() const { return ids_.bytes(); }

  private:
    gl::Texture ids_;
};

}  // namespace timeshade
