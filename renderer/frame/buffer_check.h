#pragma once

#include <string>

#include "gl/texture.h"

namespace timeshade {

/// Reads a texture of floats back and throws Error at the first value that is NaN, infinite or outside [low, high]: the
/// line names `what`, the texel and the value. Textures of other formats pass.
void requireFinite(const gl::Texture& texture, const std::string& what, float low, float high);

}  // namespace timeshade
