#pragma once

#include <initializer_list>
#include <optional>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program_cache.h"
#include "passes/gpu_mesh.h"

namespace timeshade {

/// Draws moving triangles as they are at each pixel's own sample time, one stratum of the shutter per layer
/// (stochastic rasterisation, Akenine-Moller et al. 2007; a cover per triangle and stratum with an exact test per
/// fragment). The camera's samples are jittered inside the pixel, the light's lie at the texels' centres, at random
/// times or at those of a fixed pattern.
class StochasticRasterizer {
  public:
    enum class Role { Camera, Light };
    enum class Output {
        TriangleId,
        DepthOnly,
        DepthRate,      ///< and how fast the depth changes that a pixel sees of the triangle, per u
        DepthVelocity,  ///< and how fast that of the point changes that it sees
        Motion          ///< and in rgb how fast that point moves in view coordinates, per u; in a the sample's time
    };

    explicit StochasticRasterizer(gl::ProgramCache& programs);

    /// Into how many strata the frame's time is cut, and how long one is, in u.
    struct Strata {
        std::uint32_t count;
        float length;
        /// Of a map: the side of a block of texels in which each has its own fixed time of the stratum (texelPhase and
        /// phaseTime of sample_pattern.shared.h). 0: a random time per texel.
        int timePattern = 0;
        /// As the frame's camera samples have them.
        static Strata ofSamples(const FramePlan& plan) { return {plan.block.strata, plan.block.timeScale, 0}; }
        /// Of a map that cuts the same time into `strata` of its own; 0: into those of the camera samples.
        static Strata ofMap(const FramePlan& plan, int strata, int timePattern = 0) {
            Strata map = ofSamples(plan);
            map.timePattern = timePattern;
            if (strata == 0) return map;
            map.length = map.length * static_cast<float>(map.count) / static_cast<float>(strata);
            map.count = static_cast<std::uint32_t>(strata);
            return map;
        }
    };

    /// What the layers hold before anything is drawn, instead of nothing: the same layers of other textures. `touched`
    /// (R8, one layer for all strata) gets 1 where anything is drawn onto that.
    struct Start {
        const gl::Texture& color;
        const gl::Texture& depth;
        const gl::Texture& dynamicPixels;
    };

    /// Draws the lists in turn. `color` (one layer a stratum, if the output has one) and `depth` (one layer a stratum,
    /// or one layer used for every stratum in turn) are cleared first, or take what `start` has. Depth is reversed:
    /// near / distance under perspective, 1 - distance / far when orthographic, 0 where nothing is. The textures are
    /// as wide as the view; they may hold fewer rows of it, those from `firstRow` on, and any of theirs beyond its last
    /// stay empty. The frame's uniforms and the mesh must be bound.
    void draw(const GpuMesh& mesh, const ViewPlan& view, std::initializer_list<const TriangleLists*> lists, Role role,
              Output output, const Strata& strata, const gl::Texture* color, const gl::Texture& depth,
              const Start* start = nullptr, int firstRow = 0);

    std::size_t bytes() const;

  private:
    /// A plan's lists on the GPU.
    struct Uploaded {
        std::optional<gl::Buffer> small, large;
        std::optional<gl::Texture> largeView;
        std::size_t smallCount = 0, largeCount = 0;
    };
    static void upload(Uploaded& uploaded, const TriangleLists& lists);
    void clear(Output output, bool color) const;

    gl::ProgramCache& programs_;
    gl::Framebuffer target_;
    gl::VertexArray none_;
    std::vector<Uploaded> uploaded_;
};

}  // namespace timeshade
