#pragma once

#include "gl/late_texels.h"
#include "image/image_file.h"

namespace timeshade {

/// A picture that the device has been told to draw, read some frames later: by then it is there, and nobody waits.
class LatePicture {
  public:
    /// Of 8 bits a channel, RGBA.
    explicit LatePicture(const gl::Texture& picture);
    /// Waits where the device is not there yet.
    DisplayImage take();

  private:
    gl::LateTexels texels_;
    int width_, height_;
};

}  // namespace timeshade
