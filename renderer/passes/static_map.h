#pragma once

#include <optional>

#include "passes/shadow_map.h"
#include "passes/stochastic_rasterizer.h"

namespace timeshade {

/// The nearest depth per texel of triangles that are static in the light's own frame: one ordinary shadow map says all
/// about them for the whole shutter. Reversed depth as in ShadowMap, 0 where there is nothing.
class StaticMap {
  public:
    /// Which texels a triangle covers: as a rasteriser of fixed-point vertices has it, or, as in a
    /// StochasticRasterizer's layers, those whose exact centre it covers. A technique takes that by which it draws what
    /// is dynamic, so that the plan changes no texel.
    enum class Coverage { Rasterized, Exact };

    StaticMap(gl::ProgramCache& programs, Coverage coverage)
        : programs_(programs), coverage_(coverage), map_(programs) {}
    /// Draws plan.casters.staticCasters. The frame's uniforms and the mesh must be bound.
    void draw(const FramePlan& plan, const GpuMesh& mesh);
    const gl::Texture& depth() const { return exact_ ? *exact_ : map_.depth(); }
    /// Of rasterised coverage only.
    const ShadowMap& map() const { return map_; }
    std::size_t bytes() const { return exact_ ? exact_->bytes() : map_.bytes(); }

  private:
    gl::ProgramCache& programs_;
    Coverage coverage_;
    ShadowMap map_;
    std::optional<gl::Texture> exact_;
};

}  // namespace timeshade
