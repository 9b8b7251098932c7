#pragma once

#include <optional>

#include "gl/texture.h"
#include "image/image_file.h"

namespace timeshade {

/// Puts the image into the texture, which is made anew where its size differs. Its first row is the image's uppermost.
void upload(std::optional<gl::Texture>& texture, const DisplayImage& image);

}  // namespace timeshade
