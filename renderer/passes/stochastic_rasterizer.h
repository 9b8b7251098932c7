#pragma once

#include <optional>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/gpu_mesh.h"

namespace timeshade {

/// Draws moving triangles as they are at each pixel's own sample time, one stratum of the shutter per layer
/// (stochastic rasterisation, Akenine-Moller et al. 2007; a cover per triangle and stratum with an exact test per
/// fragment). The camera's samples are jittered inside the pixel, the light's lie at the texels' centres.
class StochasticRasterizer {
  public:
    enum class Role { Camera, Light };
    enum class Output { TriangleId, DepthOnly, DepthVelocity };

    explicit StochasticRasterizer(gl::ProgramCache& programs);

    /// `color` (one layer a stratum, if the output has one) and `depth` (one layer a stratum, or one layer used for
    /// every stratum in turn) are cleared first. Depth is reversed: near / distance under perspective, 1 - distance / far when
    /// orthographic, 0 where nothing is. The frame's uniforms and the mesh must be bound.
    void draw(const GpuMesh& mesh, const ViewPlan& view, Role role, Output output, std::uint32_t strata,
              const gl::Texture* color, const gl::Texture& depth);

    std::size_t bytes() const;

  private:
    void uploadLists(const ViewPlan& view);

    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
    gl::VertexArray none_;
    std::optional<gl::Buffer> small_, large_;
    std::optional<gl::Texture> largeView_;
};

} // namespace timeshade
