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

    /// R8: 1 in pixels where any sample sees something dynamic, 0 elsewhere. Null where that is not known, or nothing
    /// dynamic is before the camera.
    const gl::Texture* dynamicPixels() const { return dynamicPixels_; }
    void setDynamicPixels(const gl::Texture* mask) { dynamicPixels_ = mask; }

  private:
    gl::Texture ids_;
    const gl::Texture* dynamicPixels_ = nullptr;
};

}  // namespace timeshade
