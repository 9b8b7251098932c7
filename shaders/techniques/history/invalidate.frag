// Pixels that are tested in this frame. All others have converged; they are discarded here, which keeps them from the
// lookup by the depth test. A converged pixel is tested again when its re-test period is over, and is invalidated by a
// dynamic triangle in it or between it and the light, and by an implausible history.
//
// DYNAMIC_CASTERS: there are such. DYNAMIC_SEEN: a texture marks the pixels in which they are seen.
#include "techniques/history/blocks.glsl"
#include "techniques/history/texel.glsl"

uniform sampler2D past;
uniform usampler2D periods;

const uint CELL_MASK = uint(RETEST_SIDE - 1);
// `retest`: as packed by retestPeriodOf in lookup.frag.
ivec2 firstCell(uint retest) { return ivec2(retest & CELL_MASK, (retest >> RETEST_CELL_BITS) & CELL_MASK); }
ivec2 lastCell(uint retest) {
    return ivec2((retest >> (2 * RETEST_CELL_BITS)) & CELL_MASK, (retest >> (3 * RETEST_CELL_BITS)) & CELL_MASK);
}
// Of a pixel in which nothing is to be tested.
bool isNowhere(uint retest) { return any(lessThan(lastCell(retest), firstCell(retest))); }

#ifdef DYNAMIC_CASTERS
uniform sampler2DArray dynamicMask;
#ifdef DYNAMIC_SEEN
uniform sampler2D dynamicPixels;
#else
uniform usamplerBuffer dynamicFlags;
#endif

const int MAX_WALK = 16;  // texels along a side: a pixel on a silhouette may hold positions far apart

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

// Is any of the pixel's cells of the light's image plane overlapped by a dynamic caster, in front of its surface or
// behind?
bool dynamicCasterNear(uint retest) {
    if (isNowhere(retest)) return false;
    ivec2 low = firstCell(retest), high = lastCell(retest);
    int side = int(history.dynamicMaskSize);
    low = low * side / RETEST_SIDE;
    ivec2 extent = ((high + 1) * side + RETEST_SIDE - 1) / RETEST_SIDE - low;
    if (max(extent.x, extent.y) > MAX_WALK) return true;
    float any = 0.0;
    for (int i = 0; i < extent.x * extent.y; ++i)
        any = max(any, texelFetch(dynamicMask, ivec3(low + ivec2(i % extent.x, i / extent.x), 0), 0).x);
    return any > 0.0;
}
#endif

// The phase of a tile within the period: neighbouring tiles are tested in different frames, whatever the period.
uint phaseOf(uvec2 tile) {
    uvec2 high = tile >> 1;
    return ((tile.x ^ tile.y) & 1u) | ((tile.y & 1u) << 1) | (((high.x ^ high.y) & 1u) << 2) | ((high.y & 1u) << 3);
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    uint retest = texelFetch(periods, pixel, 0).x, period = retest >> RETEST_PERIOD_SHIFT;
    vec4 h = texelFetch(past, pixel, 0);
    bool due = !plausible(h) && !(isNowhere(retest) && h == vec4(0.0));
    uint phase = history.round + phaseOf(uvec2(pixel) / uint(RETEST_TILE));
    if (period != RETEST_NEVER) due = due || (phase & ((1u << period) - 1u)) < history.framesDue;
#ifdef DYNAMIC_CASTERS
    due = due || dynamicCasterNear(retest) || dynamicCasterSeen(pixel);
#endif
    if (!due) discard;
}
