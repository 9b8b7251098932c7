#pragma once

#include <optional>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/gpu_mesh.h"

namespace timeshade {

/// An ordinary shadow map: the nearest depth per texel with everything as it is at one instant u of the shutter.
/// Reversed depth, as in StochasticRasterizer. All triangles are drawn, from both sides.
class ShadowMap {
  public:
    explicit ShadowMap(gl::ProgramCache& programs) : programs_(programs) {}
    /// The frame's uniforms must be bound. `mapFromPlane` takes (s, t, 1) of the light's map plane to the map, homogeneous
    /// with a weight that is positive inside it: a rotation, a shift, a perspective warp. What is stored is the reversed depth
    /// divided by that weight.
    void draw(const FramePlan& plan, const GpuMesh& mesh, float instant, const glm::mat3& mapFromPlane = glm::mat3(1.0f));
    const gl::Texture& depth() const { return *depth_; }
    std::size_t bytes() const { return depth_ ? depth_->bytes() : 0; }

  private:
    gl::ProgramCache& programs_;
    std::optional<gl::Framebuffer> target_;
    std::optional<gl::Texture> depth_;
};

} // namespace timeshade
