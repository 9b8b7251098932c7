// Pixels that are asked in this frame: all others rest, and are discarded here, which keeps them from the lookup by the depth test.
// A pixel is woken by its turn, by something that moves in it or between it and the light, and by a history that can't be true.
// DYNAMIC_CASTERS: there are such. DYNAMIC_SEEN: a texture tells in which pixels they are seen.
#include "techniques/history/blocks.glsl"
#include "techniques/history/texel.glsl"

uniform sampler2D past;
uniform usampler2D periods;

const uint CELL_MASK = uint(RETEST_SIDE - 1);
ivec2 firstCell(uint rest) { return ivec2(rest & CELL_MASK, (rest >> RETEST_CELL_BITS) & CELL_MASK); }
ivec2 lastCell(uint rest) { return ivec2((rest >> (2 * RETEST_CELL_BITS)) & CELL_MASK, (rest >> (3 * RETEST_CELL_BITS)) & CELL_MASK); }
// Of a pixel in which nothing is to be tested.
bool isNowhere(uint rest) { return any(lessThan(lastCell(rest), firstCell(rest))); }

#ifdef DYNAMIC_CASTERS
uniform sampler2DArray dynamicMask;
#ifdef DYNAMIC_SEEN
uniform sampler2D dynamicPixels;
#else
uniform usamplerBuffer dynamicFlags;
#endif

const int MAX_WALK = 16;  // texels along a side: a pixel on a silhouette may hold places far apart

bool dynamicCasterSeen(ivec2 pixel) {
#ifdef DYNAMIC_SEEN
    return texelFetch(dynamicPixels, pixel, 0).x != 0.0;
#else
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
        if (id != NO_TRIANGLE && texelFetch(dynamicFlags, int(id)).x != 0u) return true;
    }
    return false;
#endif
}

// Whatever moves over its place counts, before it or behind.
bool dynamicCasterNear(uint rest) {
    if (isNowhere(rest)) return false;
    ivec2 low = firstCell(rest), high = lastCell(rest);
    int side = int(history.dynamicMaskSize);
    low = low * side / RETEST_SIDE;
    ivec2 extent = ((high + 1) * side + RETEST_SIDE - 1) / RETEST_SIDE - low;
    if (max(extent.x, extent.y) > MAX_WALK) return true;
    float any = 0.0;
    for (int i = 0; i < extent.x * extent.y; ++i) any = max(any, texelFetch(dynamicMask, ivec3(low + ivec2(i % extent.x, i / extent.x), 0), 0).x);
    return any > 0.0;
}
#endif

// Tiles side by side and one above the other take turns, whatever the period.
uint numberOf(uvec2 tile) {
    uvec2 high = tile >> 1;
    return ((tile.x ^ tile.y) & 1u) | ((tile.y & 1u) << 1) | (((high.x ^ high.y) & 1u) << 2) | ((high.y & 1u) << 3);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint rest = texelFetch(periods, pixel, 0).x, period = rest >> RETEST_PERIOD_SHIFT;
    vec4 h = texelFetch(past, pixel, 0);
    bool asked = !plausible(h) && !(isNowhere(rest) && h == vec4(0.0));
    if (period != RETEST_NEVER) asked = asked || ((history.round + numberOf(uvec2(pixel) / uint(RETEST_TILE))) & ((1u << period) - 1u)) < history.framesDue;
#ifdef DYNAMIC_CASTERS
    asked = asked || dynamicCasterNear(rest) || dynamicCasterSeen(pixel);
#endif
    if (!asked) discard;
}
