#include "window/display_texture.h"

#include <vector>

namespace timeshade {

void upload(std::optional<gl::Texture>& texture, const DisplayImage& image) {
    std::vector<std::uint8_t> rgba;
    rgba.reserve(image.rgb.size() / 3 * 4);
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        rgba.insert(rgba.end(), {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2], 255});
    if (!texture || texture->width() != image.width || texture->height() != image.height)
        texture = gl::Texture::image2D("image", GL_RGBA8, image.width, image.height);
    glTextureSubImage2D(texture->name(), 0, 0, 0, image.width, image.height, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
}

}  // namespace timeshade
