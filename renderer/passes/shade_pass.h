#pragma once

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/fullscreen.h"
#include "passes/sample_buffer.h"
#include "passes/visibility_buffer.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// What the picture shows.
enum class View {
    Final,       ///< shaded, tone mapped
    Visibility,  ///< mean of lit over a pixel's camera samples, as it is
};

/// Mean over a pixel's samples of shading times lit, times the plan's weight: linear radiance, exposed.
class ShadePass {
  public:
    explicit ShadePass(gl::ProgramCache& programs) : programs_(programs), target_("shade target") {}
    /// `radiance` is RGBA32F of the plan's size. add: add to what is there (brute force) instead of replacing it.
    void draw(const FramePlan& plan, const Fullscreen& fullscreen, const SampleBuffer& samples,
              const VisibilityBuffer& visibility, View view, bool add, const gl::Texture& radiance);

  private:
    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
};

}  // namespace timeshade
