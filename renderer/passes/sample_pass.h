#pragma once

#include <optional>

#include "passes/sample_buffer.h"
#include "passes/stochastic_rasterizer.h"

namespace timeshade {

/// Finds out what every camera sample sees: shared by all techniques, so that they are compared on the same samples.
class SamplePass {
  public:
    explicit SamplePass(gl::ProgramCache& programs) : rasterizer_(programs) {}
    /// The frame's uniforms and the mesh must be bound. `samples` has the plan's size.
    void draw(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples);
    std::size_t bytes() const { return rasterizer_.bytes() + (depth_ ? depth_->bytes() : 0); }

  private:
    StochasticRasterizer rasterizer_;
    std::optional<gl::Texture> depth_;
};

} // namespace timeshade
