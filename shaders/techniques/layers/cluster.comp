// Cuts the samples around each tile into layers by their depth at the middle of the shutter, at the longest runs of
// empty bins, and determines each layer's mean motion (Andersson et al. 2015, 4.1: depth clustering, per-layer motion).
// One invocation a tile: sums are formed in one order.
#include "techniques/layers/samples.glsl"

layout(local_size_x = 8, local_size_y = 8) in;
#include "lib/work_groups.glsl"

layout(rgba32f) uniform writeonly image2DArray outputMotion;
layout(rgba32f) uniform writeonly image2DArray outputDepth;
uniform uint strata;
uniform uint layersWanted;
uniform uint leastRun;  // bins: shorter ones do not part layers

const int bins = 64;

uniform sampler2DArray blockRanges;

// Blocks: first, and behind the last.
struct Window {
    ivec2 low, high;
};

Window windowOf(ivec2 tile) {
    ivec2 low = (tile * TILE - (WINDOW - TILE) / 2) / BLOCK;
    return Window(max(low, ivec2(0)), min(low + WINDOW / BLOCK, textureSize(blockRanges, 0).xy));
}

vec2 rangeOfBlock(ivec2 block) { return texelFetch(blockRanges, ivec3(block, 0), 0).xy; }

int binOf(float depth, vec2 range) {
    float width = range.y - range.x;
    return width > 0.0 ? clamp(int((depth - range.x) / width * float(bins)), 0, bins - 1) : 0;
}

// Nearest and farthest; the first is above the second where there is nothing.
vec2 depthRange(Window w) {
    vec2 range = vec2(1e30, -1e30);
    for (int y = w.low.y; y < w.high.y; ++y)
        for (int x = w.low.x; x < w.high.x; ++x) {
            vec2 block = rangeOfBlock(ivec2(x, y));
            range = vec2(min(range.x, block.x), max(range.y, block.y));
        }
    return range;
}

uvec2 binsOfBlock(ivec2 block, vec2 range) {
    uvec2 mask = uvec2(0u);
    ivec2 low = block * BLOCK, high = min(low + BLOCK, ivec2(lightView.size));
    for (uint k = 0u; k < strata; ++k)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x) {
                if (isEmpty(ivec3(x, y, k))) continue;
                int bin = binOf(depthAtMiddle(sampleAt(ivec3(x, y, k))), range);
                mask |= uvec2(bin < 32 ? 1u << bin : 0u, bin < 32 ? 0u : 1u << (bin - 32));
            }
    return mask;
}

uvec2 occupiedBins(Window w, vec2 range) {
    uvec2 mask = uvec2(0u);
    for (int y = w.low.y; y < w.high.y; ++y)
        for (int x = w.low.x; x < w.high.x; ++x) {
            vec2 block = rangeOfBlock(ivec2(x, y));
            if (block.x <= block.y) mask |= binsOfBlock(ivec2(x, y), range);
        }
    return mask;
}

bool isOccupied(uvec2 mask, int bin) { return ((bin < 32 ? mask.x >> bin : mask.y >> (bin - 32)) & 1u) != 0u; }

// First bins of the second to fourth layer, ascending; `bins` where there is none. Of equal runs the nearer one parts.
ivec3 firstBins(uvec2 mask) {
    ivec3 lengths = ivec3(0), firsts = ivec3(bins);
    int run = 0;
    for (int bin = 0; bin < bins; ++bin) {
        if (!isOccupied(mask, bin)) {
            ++run;
            continue;
        }
        if (run >= int(leastRun)) {
            // The three longest so far, longest first.
            if (run > lengths.x) {
                lengths = ivec3(run, lengths.xy);
                firsts = ivec3(bin, firsts.xy);
            } else if (run > lengths.y) {
                lengths = ivec3(lengths.x, run, lengths.y);
                firsts = ivec3(firsts.x, bin, firsts.y);
            } else if (run > lengths.z) {
                lengths.z = run;
                firsts.z = bin;
            }
        }
        run = 0;
    }
    if (layersWanted < 4u) firsts.z = bins;
    if (layersWanted < 3u) firsts.y = bins;
    if (layersWanted < 2u) firsts.x = bins;
    int low = min(min(firsts.x, firsts.y), firsts.z), high = max(max(firsts.x, firsts.y), firsts.z);
    return ivec3(low, firsts.x + firsts.y + firsts.z - low - high, high);
}

// Sums over the samples of each layer, one component a layer.
struct Sums {
    vec4 count, motionX, motionY, square, depth, rate, low, high;
};

void addSample(inout Sums sums, ivec3 place, vec2 centre, vec2 range, ivec3 firsts) {
    MapSample s = sampleAt(place);
    float depth = depthAtMiddle(s);
    int bin = binOf(depth, range);
    int number = int(bin >= firsts.x) + int(bin >= firsts.y) + int(bin >= firsts.z);
    vec4 mine = vec4(equal(ivec4(number), ivec4(0, 1, 2, 3)));
#ifdef AS_PUBLISHED
    vec2 motion = motionInMap(s, vec2(place.xy) + 0.5, s.depth);
#else
    // Through the tile's centre; the expansion adds what is different beside it.
    vec2 motion = motionInMap(s, centre, max(depth, lightView.nearDistance));
#endif
    sums.count += mine;
    sums.motionX += mine * motion.x;
    sums.motionY += mine * motion.y;
    sums.square += mine * dot(motion, motion);
    sums.depth += mine * depth;
    sums.rate += mine * s.rate.z;
    sums.low = mix(sums.low, min(sums.low, vec4(depth)), mine);
    sums.high = mix(sums.high, max(sums.high, vec4(depth)), mine);
}

void addBlock(inout Sums sums, ivec2 block, vec2 centre, vec2 range, ivec3 firsts) {
    ivec2 low = block * BLOCK, high = min(low + BLOCK, ivec2(lightView.size));
    for (uint k = 0u; k < strata; ++k)
        for (int y = low.y; y < high.y; ++y)
            for (int x = low.x; x < high.x; ++x)
                if (!isEmpty(ivec3(x, y, k))) addSample(sums, ivec3(x, y, k), centre, range, firsts);
}

Sums sumsOf(ivec2 tile, Window w, vec2 range, ivec3 firsts) {
    Sums sums = Sums(vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(0.0), vec4(1e30), vec4(-1e30));
    for (int y = w.low.y; y < w.high.y; ++y)
        for (int x = w.low.x; x < w.high.x; ++x) {
            vec2 block = rangeOfBlock(ivec2(x, y));
            if (block.x <= block.y) addBlock(sums, ivec2(x, y), tileCentre(tile), range, firsts);
        }
    return sums;
}

void main() {
    ivec2 tile = placeInRows(imageSize(outputMotion).xy);
    if (any(greaterThanEqual(tile, imageSize(outputMotion).xy))) return;
    Window w = windowOf(tile);
    vec2 range = depthRange(w);
    if (range.x > range.y) {
        for (int i = 0; i < mostLayers; ++i) {
            imageStore(outputMotion, ivec3(tile, i), vec4(0.0));
            imageStore(outputDepth, ivec3(tile, i), vec4(1e30, -1e30, 0.0, 0.0));
        }
        return;
    }
    Sums sums = sumsOf(tile, w, range, firstBins(occupiedBins(w, range)));
    for (int i = 0; i < mostLayers; ++i) {
        float count = max(sums.count[i], 1.0);
        vec2 motion = vec2(sums.motionX[i], sums.motionY[i]) / count;
        float rate = sums.rate[i] / count, expansion = 0.0;
#if !defined(AS_PUBLISHED) && !defined(LIGHT_ORTHOGRAPHIC)
        // Held where a path would pass through the light within half a shutter.
        if (sums.count[i] > 0.0) expansion = clamp(rate / (sums.depth[i] / count), -1.5, 1.5);
#endif
        float spread = sqrt(max(sums.square[i] / count - dot(motion, motion), 0.0));
        imageStore(outputMotion, ivec3(tile, i), vec4(motion, expansion, rate));
        imageStore(outputDepth, ivec3(tile, i), vec4(sums.low[i], sums.high[i], spread, 0.0));
    }
}
