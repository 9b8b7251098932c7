#pragma once

#include <optional>

#include "core/frame_caches.h"
#include "passes/sample_buffer.h"
#include "passes/stochastic_rasterizer.h"

namespace timeshade {

/// Finds out what every camera sample sees: shared by all techniques, so that they are compared on the same samples.
/// What is static before the camera is drawn once: from the second frame in which it is the same it is cached (a number
/// and a depth a sample), and only what is dynamic is drawn on top; where nothing is dynamic, nothing is drawn.
class SamplePass {
  public:
    SamplePass(gl::ProgramCache& programs, FrameCaches& caches)
        : programs_(programs), caches_(caches), rasterizer_(programs) {}
    /// `samples` is always the same buffer until the caches are invalidated.
    void draw(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples);
    /// What the camera sees of what is static alone; null where that is not known. `samples` as drawn last.
    const gl::Texture* staticIds(const FramePlan& plan, const SampleBuffer& samples) const;
    /// Cached contents not counted.
    std::size_t bytes() const { return rasterizer_.bytes() + (depth_ ? depth_->bytes() : 0); }

  private:
    /// What the camera sees of what is static, and room for the mask of where something dynamic covers it.
    struct StaticSamples {
        StaticSamples(int width, int height, int strata);
        std::size_t bytes() const { return ids.bytes() + depth.bytes() + dynamicPixels.bytes(); }
        gl::Texture ids, depth, dynamicPixels;
    };
    void drawOntoStatic(const FramePlan& plan, const GpuMesh& mesh, SampleBuffer& samples);

    gl::ProgramCache& programs_;
    FrameCaches& caches_;
    StochasticRasterizer rasterizer_;
    std::optional<gl::Texture> depth_;
};

}  // namespace timeshade
