#pragma once

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/fullscreen.h"

namespace timeshade {

/// Linear radiance to sRGB-encoded eight bits, with a filmic curve or without.
class DisplayPass {
  public:
    explicit DisplayPass(gl::ProgramCache& programs) : programs_(programs), target_("display target") {}
    /// `picture` is RGBA8 of the same size; values are multiplied by `scale` first.
    void draw(const Fullscreen& fullscreen, const gl::Texture& radiance, float scale, bool toneMap,
              const gl::Texture& picture);

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
};

}  // namespace timeshade
