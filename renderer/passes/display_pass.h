#pragma once

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/fullscreen.h"
#include "plan/display_look.h"

namespace timeshade {

/// Linear radiance to sRGB-encoded eight bits.
class DisplayPass {
  public:
    explicit DisplayPass(gl::ProgramCache& programs) : programs_(programs), target_("display target") {}
    /// `picture` is RGBA8 of the same size; values are multiplied by `scale` first, then by the look's exposure.
    void draw(const Fullscreen& fullscreen, const gl::Texture& radiance, float scale, const DisplayLook& look,
              const gl::Texture& picture);

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
};

}  // namespace timeshade
