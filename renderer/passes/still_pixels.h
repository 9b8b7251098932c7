#pragma once

#include "core/frame_caches.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"

namespace timeshade {

/// Pixels in which nothing is other than static receivers under static casters alone. Refers to what caches hold: valid
/// until the next frame.
struct StillPixels {
    CacheKey key;            ///< of the visibility
    const gl::Texture* ids;  ///< samples and visibility of static receivers by static casters, in all pixels
    const gl::Texture* lit;
    const gl::Framebuffer*
        others;  ///< its depth test (gl::DepthEqual) lets all other pixels pass; null: there are none
};

}  // namespace timeshade
