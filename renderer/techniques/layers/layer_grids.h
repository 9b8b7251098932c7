#pragma once

#include <optional>

#include "gl/program_cache.h"
#include "gl/texture.h"
#include "passes/stochastic_rasterizer.h"
#include "technique/stored_along_line.h"
#include "technique/technique_frame.h"

namespace timeshade {

/// A time-dependent map, cut into layers by depth and moved along each layer's mean motion to the middle of the
/// shutter (Andersson, Hasselgren, Munkberg, Akenine-Moller 2015, sections 4.1 and 5). The map is cut into tiles; each
/// tile has up to four layers, formed of all samples in a window around it; each layer has a grid of cells, stretched
/// along its motion so far that all that passes through the window in the shutter falls into it. A cell holds the
/// sums of equation 7: two moments of depth, opacity and weight.
class LayerGrids {
  public:
    /// Texels of the map along a side of a tile and of its window; cells along a side of a grid.
    struct Shape {
        int tile, window, grid;
        bool operator==(const Shape&) const = default;
    };
    struct Options {
        Shape shape;
        bool asPublished;   ///< straight paths in the map, moments about 0, any empty bin parts layers
        bool filterAcross;  ///< blurs grids across large motions
        int layers;         ///< 1 to 4
        bool operator==(const Options&) const = default;
    };
    /// One layer of `depth` and `motion` a stratum.
    struct Samples {
        const gl::Texture& depth;
        const gl::Texture& motion;
        StochasticRasterizer::Strata strata;
    };

    explicit LayerGrids(gl::ProgramCache& programs) : programs_(programs) {}

    void build(const TechniqueFrame& frame, const Options& options, const Samples& samples);
    /// For programs that include layers/tile.glsl.
    static gl::ShaderDefines defines(const Options& options);
    void addInputs(gl::Inputs& inputs) const;
    /// What the layers of the tiles along a line hold at 32 times of the shutter, for storedAlong: at the centre of
    /// each part of the line that is in one texel, each layer's cell there, at its mean depth. With the options of the
    /// last build.
    void addMarks(const FramePlan& plan, const Options& options, const MapLine& line,
                  std::vector<StoredMark>& marks) const;
    std::vector<const gl::Texture*> textures() const;
    std::size_t bytes() const;

  private:
    void fit(const FramePlan& plan, const Options& options);

    gl::ProgramCache& programs_;
    glm::ivec2 tiles_{0};
    std::optional<gl::Texture> motion_, depth_, ranges_, grids_;
};

}  // namespace timeshade
