// Tiles of the light's map and their layers, as layers/cluster.comp leaves them (Andersson, Hasselgren, Munkberg,
// Akenine-Moller 2015, section 4.1, "A." below). Lengths across the map are in its texels, depths in world units, times
// in u, rates per u.
//
// TILE: width of a tile. WINDOW: of the search window centred on it (A.'s f). GRID: cells along a side of a layer's
// grid (A.'s o). AS_PUBLISHED: straight paths in the map; else straight paths in space.
#include "lib/light_projection.glsl"

const int mostLayers = 4;
// What each tile holds of each layer, nearest to the light first.
struct Layer {
    vec2 motion;      // mean over the layer's samples, at the middle of the shutter
    float expansion;  // mean depth rate over mean depth: paths in the map spread from or close upon the tile's centre
    float rate;       // mean depth rate
    float low, high;  // depths of its samples at the middle of the shutter
    float spread;     // root of the mean square difference of its samples' motions from their mean
    bool present;
};

uniform sampler2DArray layerMotion;  // motion, expansion, rate
uniform sampler2DArray layerDepth;   // low, high, spread; high < low: there is no such layer

Layer layerOf(ivec2 tile, int number) {
    vec4 motion = texelFetch(layerMotion, ivec3(tile, number), 0);
    vec4 depth = texelFetch(layerDepth, ivec3(tile, number), 0);
    return Layer(motion.xy, motion.z, motion.w, depth.x, depth.y, depth.z, depth.x <= depth.y);
}

vec2 tileCentre(ivec2 tile) { return (vec2(tile) + 0.5) * float(TILE); }

// A.'s M: from map texels about the tile's centre, at the middle of the shutter, to cells of the grid.
struct Grid {
    vec2 along;  // unit vector; the grid's first axis
    vec2 scale;  // cells a texel, along and across
};

Grid gridOf(Layer layer) {
    float way = length(layer.motion);
    Grid grid;
    // A. leaves the direction of no motion open.
    grid.along = way > 1e-4 ? layer.motion / way : vec2(1.0, 0.0);
    // Everything that passes through the window in the shutter lies within (equation 11).
    float window = float(WINDOW) * (1.0 + 0.5 * abs(layer.expansion));
    grid.scale = float(GRID) / vec2(window + way, window);
    return grid;
}

vec2 toGrid(Grid grid, vec2 x) {
    vec2 across = vec2(-grid.along.y, grid.along.x);
    return grid.scale * vec2(dot(grid.along, x), dot(across, x)) + 0.5 * float(GRID);
}

vec2 fromGrid(Grid grid, vec2 cell) {
    vec2 uv = (cell - 0.5 * float(GRID)) / grid.scale;
    return grid.along * uv.x + vec2(-grid.along.y, grid.along.x) * uv.y;
}

// Where a point of the layer at x, about the tile's centre, is `later` after (equation 5; with the expansion: the path
// of a point at the layer's mean depth that moves straight in space).
vec2 movedLater(Layer layer, vec2 x, float later) {
    return x * (1.0 - layer.expansion * later) + layer.motion * later;
}
vec2 movedBack(Layer layer, vec2 x, float later) {
    return (x - layer.motion * later) / (1.0 - layer.expansion * later);
}
