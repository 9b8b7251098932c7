#include "techniques/layers/layers_prediction.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace timeshade {

namespace {

using glm::dvec2;
using glm::dvec3;
using glm::ivec2;

constexpr int bins = 64;
constexpr int timesInStratum = 3;  // that stand for all of a stratum
constexpr double infinity = std::numeric_limits<double>::infinity();

/// What the light sees at a position of its map.
struct Seen {
    double depth = infinity;  ///< along the axis
    dvec3 rate{0.0};          ///< of the point: in texels times depth, and in depth
};

bool movesInMap(const TriangleInMap& triangle) {
    return std::any_of(std::begin(triangle.corners), std::end(triangle.corners),
                       [](const PathInMap& corner) { return corner.open != corner.close; });
}

Seen nearestAt(const ReceiverInMap& receiver, const dvec2& texel, double v, bool alsoStill) {
    Seen seen;
    for (const TriangleInMap& triangle : receiver.triangles) {
        if (!alsoStill && !movesInMap(triangle)) continue;
        const PlaneHit hit = hitOf(triangle, texel / receiver.mapSize, v);
        if (!hit.inside || hit.distance <= receiver.nearDistance || hit.distance >= seen.depth) continue;
        seen.depth = hit.distance;
        seen.rate = dvec3(0.0);
        for (int i = 0; i < 3; ++i)
            seen.rate += hit.inSpace[i] * (triangle.corners[i].close - triangle.corners[i].open);
        seen.rate *= dvec3(receiver.mapSize, 1.0);
    }
    return seen;
}

struct Cell {
    double moment1 = 0.0, moment2 = 0.0, opaque = 0.0, weight = 0.0;
    void add(const Cell& cell, double share) {
        moment1 += share * cell.moment1;
        moment2 += share * cell.moment2;
        opaque += share * cell.opaque;
        weight += share * cell.weight;
    }
};

/// One layer of a tile; its own samples' means, and its grid.
struct ModelLayer {
    dvec2 motion{0.0};
    double expansion = 0.0, rate = 0.0, low = infinity, high = -infinity, spread = 0.0;
    dvec2 along{1.0, 0.0}, scale{1.0};
    std::vector<Cell> cells;

    dvec2 later(const dvec2& x, double time) const { return x * (1.0 - expansion * time) + motion * time; }
    dvec2 earlier(const dvec2& x, double time) const { return (x - motion * time) / (1.0 - expansion * time); }
};

dvec2 across(const dvec2& along) { return {-along.y, along.x}; }

/// The receiver as the map sees it at a time: texels, depth, and how that changes a texel along its plane.
struct Place {
    double u = 0.0;
    dvec2 position{0.0};
    double depth = 0.0;
    dvec2 slope{0.0};
};

Place placeOf(const ReceiverInMap& receiver, double u) {
    const dvec3 p = receiver.path.at(u);
    Place place{u, dvec2(p) / p.z * receiver.mapSize, p.z, dvec2(0.0)};
    const double step = 0.5;
    for (int i = 0; i < 2; ++i) {
        dvec2 offset(0.0);
        offset[i] = step;
        const auto depthAt = [&](const dvec2& at) {
            return hitOf(receiver.triangles[receiver.own], at / receiver.mapSize, u).distance;
        };
        const double steepest = 16.0 * receiver.texelAngle * p.z;
        const double slope = depthAt(place.position + offset) - depthAt(place.position - offset);
        place.slope[i] = std::isfinite(slope) ? std::clamp(slope, -steepest, steepest) : 0.0;
    }
    return place;
}

double chebyshev(double fromMean, double variance) { return variance / (variance + fromMean * fromMean); }

}  // namespace

/// A tile's layers, made as the conversion makes them.
struct LayersPrediction::Tile {
    dvec2 centre;
    std::vector<ModelLayer> layers;
    LayerGrids::Options options;

    struct Sample {
        dvec2 texel;
        double time;
        Seen seen;
        int layer = 99;  ///< 99: behind all
        double atMiddle() const { return seen.depth + seen.rate.z * (0.5 - time); }
    };
    std::vector<Sample> samples;

    Tile(const ReceiverInMap& receiver, const ivec2& tile, const Options& wanted);
    void sort(const Options& wanted);
    void average();
    void deposit(ModelLayer& layer, int number);
    void filterAcross(ModelLayer& layer) const;
    dvec2 toGrid(const ModelLayer& layer, const dvec2& x) const {
        return layer.scale * dvec2(glm::dot(layer.along, x), glm::dot(across(layer.along), x)) +
               0.5 * options.shape.grid;
    }
    dvec2 fromGrid(const ModelLayer& layer, const dvec2& cell) const {
        const dvec2 uv = (cell - 0.5 * options.shape.grid) / layer.scale;
        return layer.along * uv.x + across(layer.along) * uv.y;
    }
    const Cell& cellAt(const ModelLayer& layer, ivec2 cell) const {
        cell = glm::clamp(cell, ivec2(0), ivec2(options.shape.grid - 1));
        return layer.cells[static_cast<std::size_t>(cell.y * options.shape.grid + cell.x)];
    }
    Cell bilinear(const ModelLayer& layer, const dvec2& g) const;
    double through(const ModelLayer& layer, const Place& place, const Place& first, const Place& last, double bias,
                   bool equation9Alone) const;
    double published(const ModelLayer& layer, const Place& place, const dvec2& a, const dvec2& b, double bias,
                     bool equation9Alone) const;
    double repaired(const ModelLayer& layer, const Place& first, const Place& last, const dvec2& a, const dvec2& b,
                    double bias) const;
};

LayersPrediction::Tile::Tile(const ReceiverInMap& receiver, const ivec2& tile, const Options& wanted)
    : centre((dvec2(tile) + 0.5) * double(wanted.grids.shape.tile)), options(wanted.grids) {
    const auto [size, window, grid] = options.shape;
    const int strata = (wanted.strata > 0 ? wanted.strata : receiver.strata) * timesInStratum;
    const ivec2 low = tile * size - (window - size) / 2;
    for (int k = 0; k < strata; ++k)
        for (int y = std::max(low.y, 0); y < std::min(low.y + window, int(receiver.mapSize.y)); ++y)
            for (int x = std::max(low.x, 0); x < std::min(low.x + window, int(receiver.mapSize.x)); ++x) {
                const dvec2 texel(x + 0.5, y + 0.5);
                const double time = (k + 0.5) / strata;
                samples.push_back({texel, time, nearestAt(receiver, texel, time, options.asPublished)});
            }
    sort(wanted);
    average();
    for (std::size_t i = 0; i < layers.size(); ++i) deposit(layers[i], static_cast<int>(i));
    samples.clear();
}

/// At the longest runs of empty bins of depth at the middle of the shutter.
void LayersPrediction::Tile::sort(const Options& wanted) {
    double low = infinity, high = -infinity;
    for (const Sample& s : samples) {
        if (s.seen.depth == infinity) continue;
        low = std::min(low, s.atMiddle());
        high = std::max(high, s.atMiddle());
    }
    if (low > high) return;
    const auto binOf = [&](const Sample& s) {
        return high > low ? std::clamp(static_cast<int>((s.atMiddle() - low) / (high - low) * bins), 0, bins - 1) : 0;
    };
    bool occupied[bins] = {};
    for (const Sample& s : samples)
        if (s.seen.depth != infinity) occupied[binOf(s)] = true;
    std::vector<std::pair<int, int>> runs;  // length, the bin behind it
    const int least = wanted.grids.asPublished ? 1 : 2;
    for (int bin = 0, run = 0; bin < bins; ++bin) {
        if (occupied[bin] && run >= least) runs.emplace_back(run, bin);
        run = occupied[bin] ? 0 : run + 1;
    }
    std::stable_sort(runs.begin(), runs.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
    runs.resize(std::min(runs.size(), static_cast<std::size_t>(options.layers - 1)));
    layers.resize(runs.size() + 1);
    for (Sample& s : samples)
        if (s.seen.depth != infinity)
            s.layer = static_cast<int>(
                std::count_if(runs.begin(), runs.end(), [&](const auto& run) { return binOf(s) >= run.second; }));
}

void LayersPrediction::Tile::average() {
    for (std::size_t i = 0; i < layers.size(); ++i) {
        ModelLayer& layer = layers[i];
        double count = 0.0, depth = 0.0, square = 0.0;
        for (const Sample& s : samples) {
            if (s.layer != static_cast<int>(i)) continue;
            const double z = s.atMiddle();
            const dvec2 motion = options.asPublished ? (dvec2(s.seen.rate) - s.texel * s.seen.rate.z) / s.seen.depth
                                                     : (dvec2(s.seen.rate) - centre * s.seen.rate.z) / z;
            ++count;
            layer.motion += motion;
            square += glm::dot(motion, motion);
            layer.rate += s.seen.rate.z;
            depth += z;
            layer.low = std::min(layer.low, z);
            layer.high = std::max(layer.high, z);
        }
        layer.motion /= count;
        layer.rate /= count;
        layer.spread = std::sqrt(std::max(square / count - glm::dot(layer.motion, layer.motion), 0.0));
        if (!options.asPublished) layer.expansion = std::clamp(layer.rate / (depth / count), -1.5, 1.5);
        const double way = glm::length(layer.motion);
        if (way > 1e-4) layer.along = layer.motion / way;
        const double window = options.shape.window * (1.0 + 0.5 * std::abs(layer.expansion));
        layer.scale = double(options.shape.grid) / dvec2(window + way, window);
    }
}

void LayersPrediction::Tile::deposit(ModelLayer& layer, int number) {
    const int grid = options.shape.grid;
    layer.cells.assign(static_cast<std::size_t>(grid * grid), Cell());
    for (const Sample& s : samples) {
        if (s.layer < number) continue;
        const double later = 0.5 - s.time;
        const dvec2 g = glm::floor(toGrid(layer, layer.later(s.texel - centre, later)));
        if (g.x < 0.0 || g.y < 0.0 || g.x >= grid || g.y >= grid) continue;
        Cell& cell = layer.cells[static_cast<std::size_t>(g.y * grid + g.x)];
        cell.weight += 1.0;
        if (s.layer != number) continue;
        const double z = s.seen.depth + layer.rate * later;
        cell.opaque += 1.0;
        cell.moment1 += z;
        cell.moment2 += z * z;
    }
    if (options.filterAcross) filterAcross(layer);
}

void LayersPrediction::Tile::filterAcross(ModelLayer& layer) const {
    const int grid = options.shape.grid;
    const double halfWidth = 0.05 * (glm::length(layer.motion) - 2.0);
    const std::vector<Cell> from = layer.cells;
    for (int y = 0; y < grid; ++y)
        for (int x = 0; x < grid; ++x)
            for (int i = 1; i < halfWidth && i <= 4; ++i)
                for (const int row : {y - i, y + i})
                    if (row >= 0 && row < grid)
                        layer.cells[static_cast<std::size_t>(y * grid + x)].add(
                            from[static_cast<std::size_t>(row * grid + x)], 1.0 - i / halfWidth);
}

Cell LayersPrediction::Tile::bilinear(const ModelLayer& layer, const dvec2& g) const {
    const dvec2 floored = glm::floor(g - 0.5), f = g - 0.5 - floored;
    Cell sum;
    for (int i = 0; i < 4; ++i)
        sum.add(cellAt(layer, ivec2(floored) + ivec2(i & 1, i >> 1)),
                ((i & 1) != 0 ? f.x : 1.0 - f.x) * ((i >> 1) != 0 ? f.y : 1.0 - f.y));
    return sum;
}

double LayersPrediction::Tile::through(const ModelLayer& layer, const Place& place, const Place& first,
                                       const Place& last, double bias, bool equation9Alone) const {
    const dvec2 a = toGrid(layer, layer.later(first.position - centre, 0.5 - first.u));
    const dvec2 b = toGrid(layer, layer.later(last.position - centre, 0.5 - last.u));
    return options.asPublished ? published(layer, place, a, b, bias, equation9Alone)
                               : repaired(layer, first, last, a, b, bias);
}

/// Equations 8 to 10.
double LayersPrediction::Tile::published(const ModelLayer& layer, const Place& place, const dvec2& a, const dvec2& b,
                                         double bias, bool equation9Alone) const {
    const double grid = options.shape.grid;
    const int taps = std::clamp(static_cast<int>(std::ceil(glm::length(b - a))), 1, 16);
    Cell sum;
    for (int i = 0; i < taps; ++i)
        sum.add(bilinear(layer, glm::clamp(glm::mix(a, b, (i + 0.5) / taps), dvec2(0.5), dvec2(grid - 0.5))), 1.0);
    const ivec2 middle(glm::floor(0.5 * (a + b)));
    for (int ring = 1; ring < int(grid) && sum.weight <= 0.0; ++ring)
        for (int y = std::max(middle.y - ring, 0); y <= std::min(middle.y + ring, int(grid) - 1); ++y)
            for (int x = std::max(middle.x - ring, 0); x <= std::min(middle.x + ring, int(grid) - 1); ++x)
                sum.add(cellAt(layer, {x, y}), 1.0);
    if (sum.weight <= 0.0 || sum.opaque <= 0.0) return 1.0;
    const double mean = sum.moment1 / sum.opaque;
    const double variance = std::max(sum.moment2 / sum.opaque - mean * mean, 1e-20);
    const double depth = place.depth + (0.5 - place.u) * layer.rate - bias;
    const double v = depth <= mean && !equation9Alone ? 1.0 : chebyshev(depth - mean, variance);
    return 1.0 - sum.opaque / sum.weight * (1.0 - v);
}

/// Each cell is tested on its own, against the receiver's plane.
double LayersPrediction::Tile::repaired(const ModelLayer& layer, const Place& first, const Place& last, const dvec2& a,
                                        const dvec2& b, double bias) const {
    const double grid = options.shape.grid;
    double lit = 0.0, weight = 0.0;
    const auto test = [&](const ivec2& cell, const Place& place, double share) {
        const ivec2 inside = glm::clamp(cell, ivec2(0), ivec2(int(grid) - 1));
        const Cell& sums = cellAt(layer, inside);
        const double later = 0.5 - place.u;
        const dvec2 at = centre + layer.earlier(fromGrid(layer, dvec2(inside) + 0.5), later);
        const double depth = place.depth + glm::dot(place.slope, at - place.position) + later * layer.rate - bias;
        double v = depth < layer.low ? 1.0 : 0.0;
        if (depth >= layer.low && depth <= layer.high && sums.opaque > 0.0) {
            const double mean = sums.moment1 / sums.opaque, least = 1e-6 * depth;
            v = depth <= mean
                    ? 1.0
                    : chebyshev(depth - mean, std::max(sums.moment2 / sums.opaque - mean * mean, least * least));
        }
        lit += share * (sums.weight - sums.opaque * (1.0 - v));
        weight += share * sums.weight;
    };
    const int taps = std::clamp(static_cast<int>(std::ceil(glm::length(b - a))), 1, 16);
    const auto placeAt = [&](double share) {
        return Place{glm::mix(first.u, last.u, share), glm::mix(first.position, last.position, share),
                     glm::mix(first.depth, last.depth, share), 0.5 * (first.slope + last.slope)};
    };
    for (int i = 0; i < taps; ++i) {
        const double share = (i + 0.5) / taps;
        const dvec2 g = glm::clamp(glm::mix(a, b, share), dvec2(0.5), dvec2(grid - 0.5)) - 0.5;
        const dvec2 floored = glm::floor(g), f = g - floored;
        for (int j = 0; j < 4; ++j)
            test(ivec2(floored) + ivec2(j & 1, j >> 1), placeAt(share),
                 ((j & 1) != 0 ? f.x : 1.0 - f.x) * ((j >> 1) != 0 ? f.y : 1.0 - f.y));
    }
    const ivec2 middle(glm::floor(0.5 * (a + b)));
    for (int ring = 1; ring <= 3 && weight <= 0.0; ++ring)
        for (int y = std::max(middle.y - ring, 0); y <= std::min(middle.y + ring, int(grid) - 1); ++y)
            for (int x = std::max(middle.x - ring, 0); x <= std::min(middle.x + ring, int(grid) - 1); ++x)
                test({x, y}, placeAt(0.5), 1.0);
    return weight > 0.0 ? lit / weight : 1.0;
}

const LayersPrediction::Tile& LayersPrediction::tileAt(const ReceiverInMap& receiver, const ivec2& tile) const {
    if (scene_ != &receiver.triangles) tiles_.clear();
    scene_ = &receiver.triangles;
    auto& known = tiles_[{tile.x, tile.y}];
    if (!known) known = std::make_shared<Tile>(receiver, tile, options_);
    return *known;
}

bool LayersPrediction::inStaticShadow(const ReceiverInMap& receiver, double u) const {
    const dvec3 p = receiver.path.at(u);
    const dvec2 texel = receiver.texelCentre(dvec2(p) / p.z);
    return std::any_of(receiver.triangles.begin(), receiver.triangles.end(), [&](const TriangleInMap& triangle) {
        if (movesInMap(triangle)) return false;
        const PlaneHit hit = hitOf(triangle, texel, u);
        return hit.inside && hit.distance > receiver.nearDistance &&
               hit.distance < p.z * (1.0 - options_.biasTexels * receiver.texelAngle);
    });
}

double LayersPrediction::litInTile(const ReceiverInMap& receiver, double u, const ivec2& number) const {
    const Tile& tile = tileAt(receiver, number);
    const Place place = placeOf(receiver, u);
    const double bias = options_.biasTexels * receiver.texelAngle * place.depth;
    const double length = 1.0 / receiver.strata, begin = std::floor(u / length) * length;
    const bool published = options_.grids.asPublished;
    const Place first = placeOf(receiver, published ? u - 0.5 * length : begin),
                last = placeOf(receiver, published ? u + 0.5 * length : begin + length);
    double visible = 1.0;
    for (const ModelLayer& layer : tile.layers)
        visible *= tile.through(layer, place, first, last, bias, options_.equation9Alone);
    return visible;
}

std::optional<double> LayersPrediction::lit(const ReceiverInMap& receiver, double u) const {
    if (!options_.grids.asPublished && inStaticShadow(receiver, u)) return 0.0;
    const dvec3 p = receiver.path.at(u);
    const double size = options_.grids.shape.tile;
    const dvec2 position = dvec2(p) / p.z * receiver.mapSize;
    const ivec2 tile(glm::floor(position / size));
    if (!options_.neighbourTiles) return litInTile(receiver, u, tile);
    const dvec2 outwards = (position - (dvec2(tile) + 0.5) * size) / (0.5 * size);
    double lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        double chance = 1.0;
        ivec2 chosen = tile;
        for (int axis = 0; axis < 2; ++axis) {
            const double other = 0.5 * std::clamp((std::abs(outwards[axis]) - 1.0 / 3.0) * 1.5, 0.0, 1.0);
            const bool taken = (i >> axis & 1) != 0;
            chance *= taken ? other : 1.0 - other;
            if (taken) chosen[axis] += outwards[axis] < 0.0 ? -1 : 1;
        }
        if (chance > 0.0) lit += chance * litInTile(receiver, u, chosen);
    }
    return lit;
}

}  // namespace timeshade
