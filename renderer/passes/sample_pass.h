#pragma once

#include <cstdint>
#include <optional>

#include "passes/sample_buffer.h"
#include "passes/stochastic_rasterizer.h"

namespace timeshade {

/// Finds out what every camera sample sees: shared by all techniques, so that they are compared on the same samples.
/// What stands still before the camera is drawn once: from the second frame in which it is the same it is kept (a
/// number and a depth a sample), and only what moves is drawn on top; where nothing moves, nothing is drawn.
class SamplePass {
  public:
    explicit SamplePass(gl::ProgramCache& programs) : programs_(programs), rasterizer_(programs) {}
    void draw(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples);
    /// What the camera sees of what stands still alone; null where that is not known. `samples` as drawn last.
    const gl::Texture* staticIds(const FramePlan& plan, const SampleBuffer& samples) const;
    /// Where something that moves is seen in any stratum: R8, 0 elsewhere. Null where nothing moves before the camera.
    const gl::Texture* dynamicPixels(const FramePlan& plan) const {
        return plan.camera.dynamicTriangles.empty() || !dynamicPixels_ ? nullptr : &*dynamicPixels_;
    }
    /// The buffers are others, or were drawn into by someone else.
    void forget();
    std::size_t bytes() const;

  private:
    void drawOntoCached(const FramePlan& plan, const GpuMesh& mesh, const SampleBuffer& samples);
    void dropCache();

    gl::ProgramCache& programs_;
    StochasticRasterizer rasterizer_;
    std::optional<gl::Texture> depth_;
    std::optional<gl::Texture> cachedIds_, cachedDepth_, dynamicPixels_;
    std::uint64_t seen_ = 0;    ///< FramePlan::versions.samples of the frame before
    std::uint64_t drawn_ = 0;   ///< of what the sample buffer holds, where nothing else is in it
    std::uint64_t cached_ = 0;  ///< of what is kept
};

}  // namespace timeshade
