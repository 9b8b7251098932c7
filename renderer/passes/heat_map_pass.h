#pragma once

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/fullscreen.h"

namespace timeshade {

/// What a heat map's colours mean. low < high; a logarithmic one has 0 < low.
struct HeatScale {
    double low = 0.0, high = 1.0;
    bool logarithmic = false;
};

/// One value a pixel to a colour: shared/heat_color.shared.h.
class HeatMapPass {
  public:
    explicit HeatMapPass(gl::ProgramCache& programs) : programs_(programs), target_("heat map target") {}
    /// `values` is R32F, `picture` RGBA8 of the same size. A negative value is nothing.
    void draw(const Fullscreen& fullscreen, const gl::Texture& values, const HeatScale& scale,
              const gl::Texture& picture);

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
};

}  // namespace timeshade
