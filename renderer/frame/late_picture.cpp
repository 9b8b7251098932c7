#include "frame/late_picture.h"

#include "frame/upside_down.h"

namespace timeshade {

LatePicture::LatePicture(const gl::Texture& picture)
    : texels_(picture, GL_RGBA, GL_UNSIGNED_BYTE), width_(picture.width()), height_(picture.height()) {}

DisplayImage LatePicture::take() {
    DisplayImage image{width_, height_, {}};
    copyRowsUpsideDown<std::uint8_t, std::uint8_t>(texels_.take<std::uint8_t>(), width_, height_, image.rgb, 1);
    return image;
}

}  // namespace timeshade
