// Filtered layered shadow maps: the receiver is moved along each layer's motion to the middle of the shutter, where the
// layer's grid is filtered over its footprint and tested; the layers' visibilities are multiplied (Andersson,
// Hasselgren, Munkberg, Akenine-Moller 2015, 4.2).
//
// AS_PUBLISHED: one variance test of the filtered sums (equations 8 and 9). Otherwise each cell is tested against the
// receiver's plane, and the tests are filtered. EQUATION_9_ALONE: without the condition of Donnelly and Lauritzen 2006
// that a receiver nearer than the mean is lit. NEIGHBOUR_TILES: near a tile's border its neighbour may answer.
#include "lib/lookup.glsl"
#include "lib/map_strata.glsl"
#include "lib/pcf.glsl"
#include "shared/shutter_response.shared.h"
#include "techniques/layers/samples.glsl"

uniform sampler2DArray grids;
uniform sampler2DArray staticMap;

const int mostTaps = 16;
const int mostRings = 3;
const float darkEnough = 1e-3;  // the largest error of leaving out the layers behind

ivec2 tileOf(vec2 position, uint salt) {
    ivec2 last = (ivec2(lightView.size) + TILE - 1) / TILE - 1;
    ivec2 tile = clamp(ivec2(floor(position / float(TILE))), ivec2(0), last);
#ifdef NEIGHBOUR_TILES
    // From a third of the way to the border on, up to one in two at the border.
    vec2 outwards = (position - tileCentre(tile)) / (0.5 * float(TILE));
    vec2 chance = 0.5 * clamp((abs(outwards) - 1.0 / 3.0) / (2.0 / 3.0), 0.0, 1.0);
    uvec3 random = hashWords(uvec3(samplePixel, hashWord(frame.seed ^ salt)));
    tile += ivec2(lessThan(vec2(unitInterval(random.x), unitInterval(random.y)), chance)) * ivec2(sign(outwards));
    tile = clamp(tile, ivec2(0), last);
#endif
    return tile;
}

// The receiver at a time, as the tests want it: map position in texels, depth and how it changes a texel.
struct Place {
    float u;
    vec2 position;
    float depth;
    vec2 slope;
};

Place placeOf(Receiver r, float u) {
    MapPoint m = mapPointOf(r, u);
    // A plane that is all but edge-on says nothing about its depth a cell away.
    float steepest = 16.0 * m.texel;
    return Place(u, m.position * lightView.size, m.depth, clamp(m.slope / lightView.size, -steepest, steepest));
}

vec4 cellAt(ivec2 tile, int number, ivec2 cell) {
    return texelFetch(grids, ivec3(tile * GRID + clamp(cell, ivec2(0), ivec2(GRID - 1)), number), 0);
}

float chebyshev(float depth, float mean, float variance) {
    float d = depth - mean;
    return variance / (variance + d * d);
}

#ifdef AS_PUBLISHED
// The mean tuple over the footprint: bilinear fetches along it.
vec4 filteredTuple(ivec2 tile, int number, vec2 a, vec2 b) {
    int taps = clamp(int(ceil(length(b - a))), 1, mostTaps);
    vec4 sum = vec4(0.0);
    for (int i = 0; i < taps; ++i) {
        vec2 g = clamp(mix(a, b, (float(i) + 0.5) / float(taps)), vec2(0.5), vec2(float(GRID) - 0.5));
        vec2 f = fract(g - 0.5);
        ivec2 cell = ivec2(floor(g - 0.5));
        vec4 low = mix(cellAt(tile, number, cell), cellAt(tile, number, cell + ivec2(1, 0)), f.x);
        vec4 high = mix(cellAt(tile, number, cell + ivec2(0, 1)), cellAt(tile, number, cell + ivec2(1, 1)), f.x);
        sum += mix(low, high, f.y);
    }
    sum /= float(taps);
    // Widened until it holds a sample.
    ivec2 centre = ivec2(floor(0.5 * (a + b)));
    for (int ring = 1; ring < GRID && sum.w <= 0.0; ++ring)
        for (int y = -ring; y <= ring; ++y)
            for (int x = -ring; x <= ring; ++x) {
                ivec2 cell = centre + ivec2(x, y);
                bool inside = all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, ivec2(GRID)));
                if (inside) sum += cellAt(tile, number, cell);
            }
    return sum;
}

float visibilityThrough(ivec2 tile, int number, Layer layer, Place p, Place first, Place last, float bias) {
    Grid grid = gridOf(layer);
    vec2 c = tileCentre(tile);
    vec2 a = toGrid(grid, movedLater(layer, first.position - c, 0.5 - first.u));
    vec2 b = toGrid(grid, movedLater(layer, last.position - c, 0.5 - last.u));
    vec4 sums = filteredTuple(tile, number, a, b);
    if (sums.w <= 0.0 || sums.z <= 0.0) return 1.0;
    vec2 moments = sums.xy / sums.z;
    float depth = p.depth + (0.5 - p.u) * layer.rate - bias;
    float v = clamp(chebyshev(depth, moments.x, max(moments.y - moments.x * moments.x, 1e-20)), 0.0, 1.0);
#ifndef EQUATION_9_ALONE
    if (depth <= moments.x) v = 1.0;
#endif
    return 1.0 - sums.z / sums.w * (1.0 - v);
}
#else
// The receiver's plane over the cells of a layer's grid: what depth at the middle of the shutter is compared there.
struct PlaneOverGrid {
    float depth;  // at the corner of cell (0, 0)
    vec2 slope;   // per cell
};

// At the receiver's time the cells are where the layer's points come from.
PlaneOverGrid planeOverGrid(ivec2 tile, Layer layer, Grid grid, Place p, float bias) {
    float later = 0.5 - p.u, shrink = 1.0 / (1.0 - layer.expansion * later);
    vec2 across = vec2(-grid.along.y, grid.along.x);
    vec2 corner = tileCentre(tile) + movedBack(layer, fromGrid(grid, vec2(0.0)), later);
    PlaneOverGrid plane;
    plane.depth = p.depth + dot(p.slope, corner - p.position) + later * layer.rate - bias;
    plane.slope = vec2(dot(p.slope, grid.along), dot(p.slope, across)) * shrink / grid.scale;
    return plane;
}

// What a cell says of the receiver: its visibility times its weight, and its weight.
vec2 cellTest(ivec2 tile, int number, Layer layer, ivec2 cell, PlaneOverGrid plane) {
    cell = clamp(cell, ivec2(0), ivec2(GRID - 1));
    vec4 sums = texelFetch(grids, ivec3(tile * GRID + cell, number), 0);
    float depth = plane.depth + dot(plane.slope, vec2(cell) + 0.5);
    float visible = depth < layer.low ? 1.0 : 0.0;
    if (sums.z > 0.0 && depth >= layer.low && depth <= layer.high) {
        vec2 moments = sums.xy / sums.z;
        float middle = 0.5 * (layer.low + layer.high), least = 1e-6 * depth;
        float fromMiddle = depth - middle;
        float variance = max(moments.y - moments.x * moments.x, least * least);
        visible = fromMiddle <= moments.x ? 1.0 : chebyshev(fromMiddle, moments.x, variance);
    }
    return vec2(sums.w - sums.z * (1.0 - visible), sums.w);
}

float visibilityThrough(ivec2 tile, int number, Layer layer, Place p, Place first, Place last, float bias) {
    Grid grid = gridOf(layer);
    vec2 c = tileCentre(tile);
    vec2 a = toGrid(grid, movedLater(layer, first.position - c, 0.5 - first.u));
    vec2 b = toGrid(grid, movedLater(layer, last.position - c, 0.5 - last.u));
    int taps = clamp(int(ceil(length(b - a))), 1, mostTaps);
    vec2 sum = vec2(0.0);
    for (int i = 0; i < taps; ++i) {
        float share = (float(i) + 0.5) / float(taps);
        Place q = Place(mix(first.u, last.u, share), mix(first.position, last.position, share),
                        mix(first.depth, last.depth, share), p.slope);
        PlaneOverGrid plane = planeOverGrid(tile, layer, grid, q, bias);
        vec2 g = clamp(mix(a, b, share), vec2(0.5), vec2(float(GRID) - 0.5)) - 0.5;
        vec2 f = fract(g);
        ivec2 cell = ivec2(floor(g));
        float weight = shutterWeight(frame.response, frame.responseWidth, q.u);
        vec4 w = weight * vec4((1.0 - f.x) * (1.0 - f.y), f.x * (1.0 - f.y), (1.0 - f.x) * f.y, f.x * f.y);
        sum += w.x * cellTest(tile, number, layer, cell, plane);
        sum += w.y * cellTest(tile, number, layer, cell + ivec2(1, 0), plane);
        sum += w.z * cellTest(tile, number, layer, cell + ivec2(0, 1), plane);
        sum += w.w * cellTest(tile, number, layer, cell + ivec2(1, 1), plane);
    }
    // Nothing there: the nearest cells that hold a sample. None within three: as if the layer were not there.
    ivec2 centre = ivec2(floor(0.5 * (a + b)));
    for (int ring = 1; ring <= mostRings && sum.y <= 0.0; ++ring) {
        PlaneOverGrid plane = planeOverGrid(tile, layer, grid, p, bias);
        for (int y = -ring; y <= ring; ++y)
            for (int x = -ring; x <= ring; ++x) {
                ivec2 cell = centre + ivec2(x, y);
                bool inside = all(greaterThanEqual(cell, ivec2(0))) && all(lessThan(cell, ivec2(GRID)));
                if (inside) sum += cellTest(tile, number, layer, cell, plane);
            }
    }
    return sum.y > 0.0 ? sum.x / sum.y : 1.0;
}

// The samples themselves, 3 x 3 of the receiver's stratum, each against the receiver's plane at its own time: where
// motions in one layer differ so much that their mean says nothing. 1 where they are not `wanted`: a loop that is not
// entered is the one branch that costs nothing where fragments run side by side.
float visibilityBySamples(MovingTriangle t, Receiver r, Place p, float bias, bool wanted) {
    uint layer = layerAt(r.time, stratum);
    ivec2 texel = ivec2(floor(p.position));
    float dark = 0.0;
    for (int i = 0; wanted && i < pcfTests; ++i) {
        ivec2 at = texel + pcfOffset(i);
        if (!insideMap(at)) continue;
        MapSample s = sampleAt(ivec3(at, layer));
        if (s.empty) continue;
        Place q = placeOf(pointAt(t, r.triangle, r.barycentrics, 0.5 - s.toMiddle), 0.5 - s.toMiddle);
        if (s.depth < q.depth + dot(q.slope, vec2(at) + 0.5 - q.position) - bias) dark += 1.0;
    }
    return 1.0 - dark / float(pcfTests);
}
#endif

float dynamicVisibility(MovingTriangle t, Receiver r, float u0, float u1, float bias) {
    Place p = placeOf(r, r.time);
    ivec2 tile = tileOf(p.position, stratum);
#ifdef AS_PUBLISHED
    // The receiver is taken to stand still, as the camera does, for the stratum's length around its own time.
    float around = 0.5 * (u1 - u0);
    Place first = placeOf(r, r.time - around), last = placeOf(r, r.time + around);
#else
    Place first = placeOf(pointAt(t, r.triangle, r.barycentrics, u0), u0);
    Place last = placeOf(pointAt(t, r.triangle, r.barycentrics, u1), u1);
#endif
    float visible = 1.0;
    bool bySamples = false;
    for (int l = 0; l < mostLayers && visible >= darkEnough && !bySamples; ++l) {
        Layer layer = layerOf(tile, l);
        if (!layer.present) break;
#ifndef AS_PUBLISHED
        bySamples = layer.spread > 6.0 + 2.0 * length(layer.motion);
#endif
        visible *= visibilityThrough(tile, l, layer, p, first, last, bias);
    }
#ifndef AS_PUBLISHED
    float fromSamples = visibilityBySamples(t, r, p, bias, bySamples);
    if (bySamples) visible = fromSamples;
#endif
    return visible;
}

float litOver(MovingTriangle t, Receiver r, float u0, float u1) {
    MapPoint m = mapPointOf(r, r.time);
    ivec2 texel;
    if (!texelOf(m, texel)) return 1.0;
    float bias = setting.bias * m.texel, lit = 1.0;
#ifndef AS_PUBLISHED
    bias = depthBias(m, setting.bias, setting.slope_bias);
    if (m.depth - bias > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return 0.0;
#endif
#ifdef DYNAMIC_CASTERS
    lit = dynamicVisibility(t, r, u0, u1, bias);
#endif
    return lit;
}

#include "lib/lookup_main.glsl"
