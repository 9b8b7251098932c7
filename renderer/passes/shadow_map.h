#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/gpu_mesh.h"

namespace timeshade {

/// An ordinary shadow map: the nearest depth per texel with everything as it is at one instant u of the shutter.
/// Reversed depth, as in StochasticRasterizer, 0 where there is nothing. Triangles are drawn from both sides.
class ShadowMap {
  public:
    /// `keepsTriangles`: beside the depth the number of the triangle that it is of, R32UI, 4 bytes a texel; only where
    /// all triangles are drawn.
    explicit ShadowMap(gl::ProgramCache& programs, bool keepsTriangles = false)
        : programs_(programs), keepsTriangles_(keepsTriangles), none_("no attributes") {}
    /// All triangles of the mesh. The frame's uniforms must be bound. `mapFromPlane` takes (s, t, 1) of the light's map
    /// plane to the map, homogeneous with a weight that is positive inside it: a rotation, a shift, a perspective warp.
    /// What is stored is the reversed depth divided by that weight.
    void draw(const FramePlan& plan, const GpuMesh& mesh, float instant,
              const glm::mat3& mapFromPlane = glm::mat3(1.0f));
    /// Those of a list in ascending order.
    void draw(const FramePlan& plan, const GpuMesh& mesh, float instant, const std::vector<std::uint32_t>& triangles);
    /// As many more on top of what another map of the same size has.
    void drawOnto(const ShadowMap& start, const FramePlan& plan, const GpuMesh& mesh, float instant,
                  const std::vector<std::uint32_t>& triangles);

    const gl::Texture& depth() const { return *depth_; }
    bool keepsTriangles() const { return keepsTriangles_; }
    /// NO_TRIANGLE where nothing was drawn. Only of a map that keeps them.
    const gl::Texture& triangles() const { return *triangles_; }
    bool drawn() const { return depth_.has_value(); }
    std::size_t bytes() const { return (depth_ ? depth_->bytes() : 0) + (triangles_ ? triangles_->bytes() : 0); }

  private:
    void begin(const FramePlan& plan, float instant, const glm::mat3& mapFromPlane);
    void clear() const;

    gl::ProgramCache& programs_;
    bool keepsTriangles_;
    gl::VertexArray none_;
    std::optional<gl::Framebuffer> target_;
    std::optional<gl::Texture> depth_, triangles_;
};

}  // namespace timeshade
