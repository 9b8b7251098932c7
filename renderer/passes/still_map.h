#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/gpu_mesh.h"

namespace timeshade {

/// The nearest depth per texel of triangles that stand still in the light's own frame: one ordinary shadow map says all about
/// them for the whole shutter. Reversed depth as in ShadowMap, 0 where there is nothing.
class StillMap {
  public:
    explicit StillMap(gl::ProgramCache& programs) : programs_(programs) {}
    /// `triangles` in ascending order (LightMotion::still). The frame's uniforms must be bound.
    void draw(const FramePlan& plan, const GpuMesh& mesh, const std::vector<std::uint32_t>& triangles);
    const gl::Texture& depth() const { return *depth_; }
    bool drawn() const { return depth_.has_value(); }
    std::size_t bytes() const { return depth_ ? depth_->bytes() : 0; }

  private:
    gl::ProgramCache& programs_;
    std::optional<gl::Framebuffer> target_;
    std::optional<gl::Texture> depth_;
};

} // namespace timeshade
