// Moves the samples around a tile along each layer's motion to the middle of the shutter and sums them up in the cells
// of the layer's grid (Andersson et al. 2015, 4.1: grid setup, sample reprojection; equations 5 to 7). One work group a
// tile. Sums are integers in shared memory, so that their order makes no difference.
//
// V_FILTER: blur across the motion where it is large (section 5).
#include "techniques/layers/samples.glsl"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"

const int cells = GRID * GRID;
const float reach = 4.0;  // of a depth from the layer's middle, in half ranges

layout(rgba32f) uniform writeonly image2DArray grids;  // moments 1 and 2 about the layer's origin, opacity, weight
uniform uint strata;

shared int weights[cells];  // samples behind or in the layer in the high half, in the layer in the low half
shared int moments1[cells];
shared int moments2[cells];

ivec2 tiles() { return (ivec2(lightView.size) + TILE - 1) / TILE; }

float middleOf(Layer layer) { return 0.5 * (layer.low + layer.high); }
float halfRangeOf(Layer layer) { return max(0.5 * (layer.high - layer.low), 1e-6 * layer.high); }

// In units that the sum of a cell's samples cannot exceed, were all of them in it.
float unitsOf(float most) { return floor(float(1 << 30) / (most * float(WINDOW * WINDOW) * float(strata))); }

// What is the same for all samples of a layer.
struct Target {
    Layer layer;
    Grid grid;
    vec2 centre;     // of the tile, texels
    float before;    // border to the layer in front
    float after;     // and to the one behind
    float middle;    // depth that moments are about
    float perRange;    // one over half of its range
    vec2 units;      // of the two moments
};

void depositSample(Target to, ivec3 place) {
    MapSample s = sampleAt(place);
    float own = s.empty ? 1e30 : depthAtMiddle(s);
    vec2 moved = movedLater(to.layer, vec2(place.xy) + 0.5 - to.centre, s.toMiddle);
    ivec2 cell = ivec2(floor(toGrid(to.grid, moved)));
    if (any(lessThan(place.xy, ivec2(0))) || any(greaterThanEqual(place.xy, ivec2(lightView.size)))) return;
    // In front: what is behind is not known.
    if (own < to.before || any(lessThan(cell, ivec2(0))) || any(greaterThanEqual(cell, ivec2(GRID)))) return;
    int number = cell.y * GRID + cell.x;
    bool inside = own < to.after;
    atomicAdd(weights[number], inside ? 65537 : 65536);
    if (!inside) return;
    float z = clamp((s.depth + to.layer.rate * s.toMiddle - to.middle) * to.perRange, -reach, reach);
    atomicAdd(moments1[number], int(round(z * to.units.x)));
    atomicAdd(moments2[number], int(round(z * z * to.units.y)));
}

// Moments about the layer's middle, opacity, weight; the sums of equation 7.
vec4 cellSums(Layer layer, int number) {
    int count = weights[number] & 65535, weight = weights[number] >> 16;
    float halfRange = halfRangeOf(layer);
    float first = float(moments1[number]) / unitsOf(reach) * halfRange;
    float second = float(moments2[number]) / unitsOf(reach * reach) * halfRange * halfRange;
#ifdef AS_PUBLISHED
    // Moments about 0, in floats.
    float middle = middleOf(layer);
    second += 2.0 * middle * first + float(count) * middle * middle;
    first += float(count) * middle;
#endif
    return vec4(first, second, float(count), float(weight));
}

// A tent across the motion, of half width 0.05 (|d| - 2) cells.
vec4 filteredSums(Layer layer, int number) {
    vec4 sum = cellSums(layer, number);
#ifdef V_FILTER
    float halfWidth = 0.05 * (length(layer.motion) - 2.0);
    int row = number / GRID, most = min(int(ceil(halfWidth)) - 1, 4);
    for (int i = 1; i <= most; ++i) {
        float share = 1.0 - float(i) / halfWidth;
        if (row >= i) sum += share * cellSums(layer, number - i * GRID);
        if (row + i < GRID) sum += share * cellSums(layer, number + i * GRID);
    }
#endif
    return sum;
}

void main() {
    ivec2 all = tiles();
    int group = int(groupIndex());
    if (group >= all.x * all.y) return;
    ivec2 tile = ivec2(group % all.x, group / all.x);
    ivec2 low = tile * TILE - (WINDOW - TILE) / 2;
    int samples = WINDOW * WINDOW * int(strata);
    float before = -1e30;
    for (int l = 0; l < mostLayers; ++l) {
        Layer layer = layerOf(tile, l);
        if (!layer.present) break;
        // Half of the way to the next layer parts them.
        float after = 1e29;
        if (l + 1 < mostLayers) {
            Layer next = layerOf(tile, l + 1);
            if (next.present) after = 0.5 * (layer.high + next.low);
        }
        Target to = Target(layer, gridOf(layer), tileCentre(tile), before, after, middleOf(layer),
                           1.0 / halfRangeOf(layer), vec2(unitsOf(reach), unitsOf(reach * reach)));
        for (int i = int(gl_LocalInvocationID.x); i < cells; i += 64) {
            weights[i] = 0;
            moments1[i] = 0;
            moments2[i] = 0;
        }
        barrier();
        for (int i = int(gl_LocalInvocationID.x); i < samples; i += 64) {
            // Divisors known to the compiler: others cost more than all the rest.
            int column = i % WINDOW, row = i / WINDOW % WINDOW;
            depositSample(to, ivec3(low.x + column, low.y + row, i / (WINDOW * WINDOW)));
        }
        barrier();
        for (int i = int(gl_LocalInvocationID.x); i < cells; i += 64)
            imageStore(grids, ivec3(tile * GRID + ivec2(i % GRID, i / GRID), l), filteredSums(layer, i));
        barrier();
        before = after;
    }
}
