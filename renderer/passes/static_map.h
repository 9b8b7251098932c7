#pragma once

#include <optional>

#include "passes/shadow_map.h"
#include "passes/stochastic_rasterizer.h"

namespace timeshade {

/// The nearest depth per texel of triangles that stand still in the light's own frame: one ordinary shadow map says all
/// about them for the whole shutter, and for every frame until something of it changes (FramePlan::versions). Reversed
/// depth as in ShadowMap, 0 where there is nothing.
class StaticMap {
  public:
    /// Which texels a triangle covers: as a rasteriser of fixed-point vertices has it, or, as in a
    /// StochasticRasterizer's layers, those whose exact middle it covers. A technique takes that by which it draws what
    /// moves, so that the plan changes no texel.
    enum class Coverage { Rasterized, Exact };

    explicit StaticMap(gl::ProgramCache& programs, Coverage coverage = Coverage::Rasterized)
        : programs_(programs), coverage_(coverage), map_(programs) {}
    /// Draws plan.casters.staticCasters, unless that is what it holds. The frame's uniforms and the mesh must be bound.
    void draw(const FramePlan& plan, const GpuMesh& mesh);
    const gl::Texture& depth() const { return exact_ ? *exact_ : map_.depth(); }
    const ShadowMap& map() const { return map_; }
    bool drawn() const { return exact_ || map_.drawn(); }
    std::size_t bytes() const { return exact_ ? exact_->bytes() : map_.bytes(); }

  private:
    gl::ProgramCache& programs_;
    Coverage coverage_;
    ShadowMap map_;
    std::optional<gl::Texture> exact_;
    std::uint64_t version_ = 0;
};

}  // namespace timeshade
