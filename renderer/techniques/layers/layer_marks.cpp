#include <array>
#include <cmath>

#include "gl/read_back.h"
#include "techniques/layers/layer_grids.h"

namespace timeshade {

namespace {

constexpr int timesShown = 32;

std::vector<glm::vec4> block(const gl::Texture& texture, const glm::ivec2& low, int side, int layer) {
    std::vector<glm::vec4> values(static_cast<std::size_t>(side) * static_cast<std::size_t>(side));
    gl::readTexels(texture, {low.x, low.y, layer, side, side}, GL_RGBA, GL_FLOAT, values);
    return values;
}

/// One layer of a tile: Layer and Grid of layers/tile.glsl, and the sums of its cells.
struct StoredLayer {
    glm::dvec2 motion, along, scale;
    double expansion, rate, middle;
    std::vector<glm::vec4> cells;

    StoredLayer(const glm::dvec4& motions, const glm::dvec4& depths, const LayerGrids::Options& options)
        : motion(motions),
          expansion(motions.z),
          rate(motions.w),
          middle(options.asPublished ? 0.0 : 0.5 * (depths.x + depths.y)) {
        const double way = glm::length(motion), window = options.shape.window * (1.0 + 0.5 * std::abs(expansion));
        along = way > 1e-4 ? motion / way : glm::dvec2(1.0, 0.0);
        scale = double(options.shape.grid) / glm::dvec2(window + way, window);
    }
    /// The sums at a place about the tile's centre, in texels, at time u; all 0 beside the grid.
    glm::dvec4 sumsAt(const glm::dvec2& place, double u, int side) const {
        const double later = 0.5 - u;
        const glm::dvec2 x = place * (1.0 - expansion * later) + motion * later;
        const glm::dvec2 uv(glm::dot(along, x), glm::dot(glm::dvec2(-along.y, along.x), x));
        const glm::ivec2 cell(glm::floor(scale * uv + 0.5 * side));
        if (cell.x < 0 || cell.y < 0 || cell.x >= side || cell.y >= side) return glm::dvec4(0.0);
        return cells[static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(side) +
                     static_cast<std::size_t>(cell.x)];
    }
};

/// At all times, nearest layer first.
void addMarksOf(const StoredLayer& layer, int side, const TexelOnLine& part, const glm::dvec2& place,
                std::vector<StoredMark>& marks) {
    constexpr double step = 1.0 / timesShown;
    for (int i = 0; i < timesShown; ++i) {
        const double u = (i + 0.5) * step;
        const glm::dvec4 sums = layer.sumsAt(place, u, side);
        if (sums.z <= 0.0 || sums.w <= 0.0) continue;
        const double depth = layer.middle + sums.x / sums.z + layer.rate * (u - 0.5);
        const double change = 0.5 * step * layer.rate;
        if (depth <= std::abs(change)) continue;  // behind the light: an average that no path has
        marks.push_back({part.xFrom, part.xTo, u - 0.5 * step, u + 0.5 * step, depth - change, depth + change});
        marks.back().opacity = std::min(sums.z / sums.w, 1.0);
    }
}

}  // namespace

void LayerGrids::addMarks(const FramePlan& plan, const Options& options, const MapLine& line,
                          std::vector<StoredMark>& marks) const {
    const MapSize size = plan.request.mapSize;
    const int side = options.shape.grid;
    glm::ivec2 tile(-1);
    std::vector<StoredLayer> layers;
    for (const TexelOnLine& part : texelsAlong(line, {size.width, size.height})) {
        if (const glm::ivec2 now = part.texel / options.shape.tile; now != tile) {
            tile = now;
            layers.clear();
            for (int l = 0; l < options.layers; ++l) {
                const glm::vec4 depths = block(*depth_, tile, 1, l).front();
                if (depths.x > depths.y) break;
                layers.emplace_back(block(*motion_, tile, 1, l).front(), depths, options);
                layers.back().cells = block(*grids_, tile * side, side, l);
            }
        }
        const glm::dvec2 centre = (glm::dvec2(tile) + 0.5) * double(options.shape.tile);
        const glm::dvec2 place = line.at(0.5 * (part.xFrom + part.xTo)) * size.sides() - centre;
        for (const StoredLayer& layer : layers) addMarksOf(layer, side, part, place, marks);
    }
}

}  // namespace timeshade
