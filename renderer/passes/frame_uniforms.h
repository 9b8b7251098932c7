#pragma once

#include "gl/buffer.h"
#include "plan/frame_plan.h"

namespace timeshade {

/// The uniform blocks that all passes of a frame read.
class FrameUniforms {
  public:
    FrameUniforms();
    /// Uploads the plan's blocks and binds them.
    void set(const FramePlan& plan);

  private:
    gl::Buffer frame_, camera_, light_;
};

}  // namespace timeshade
