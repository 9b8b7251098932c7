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

    /// `keepsTriangles`: beside the depth the number of the triangle that it is of, R32UI, 4 bytes a texel; of exact
    /// coverage only.
    StaticMap(gl::ProgramCache& programs, Coverage coverage, bool keepsTriangles = false)
        : programs_(programs), coverage_(coverage), keepsTriangles_(keepsTriangles), map_(programs) {}
    /// Draws plan.casters.staticCasters. The frame's uniforms and the mesh must be bound.
    void draw(const FramePlan& plan, const GpuMesh& mesh);
    const gl::Texture& depth() const { return exact_ ? *exact_ : map_.depth(); }
    /// Of rasterised coverage only.
    const ShadowMap& map() const { return map_; }
    /// NO_TRIANGLE where there is nothing. Only of a map that keeps them.
    const gl::Texture& triangles() const { return *triangles_; }
    std::size_t bytes() const {
        return (exact_ ? exact_->bytes() : map_.bytes()) + (triangles_ ? triangles_->bytes() : 0);
    }

  private:
    gl::ProgramCache& programs_;
    Coverage coverage_;
    bool keepsTriangles_;
    ShadowMap map_;
    std::optional<gl::Texture> exact_, triangles_;
};

}  // namespace timeshade
