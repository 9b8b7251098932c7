// Pixels that are asked in this frame: all others rest, and are discarded here, which keeps them from the lookup by the depth test.
// A pixel is woken by its turn, by something that moves in it or between it and the light, and by a history that can't be true.
// MOVERS: there are such. MOVING_SEEN: a texture tells in which pixels they are seen.
#include "techniques/history/blocks.glsl"
#include "techniques/history/texel.glsl"

layout(binding = PAST_UNIT) uniform sampler2D past;
layout(binding = RESTS_UNIT) uniform usampler2D rests;

const uint CELL_MASK = uint(REST_SIDE - 1);
ivec2 firstCell(uint rest) { return ivec2(rest & CELL_MASK, (rest >> REST_CELL_BITS) & CELL_MASK); }
ivec2 lastCell(uint rest) { return ivec2((rest >> (2 * REST_CELL_BITS)) & CELL_MASK, (rest >> (3 * REST_CELL_BITS)) & CELL_MASK); }
// Of a pixel in which nothing is to be tested.
bool isNowhere(uint rest) { return any(lessThan(lastCell(rest), firstCell(rest))); }

#ifdef MOVERS
layout(binding = MOVER_MASK_UNIT) uniform sampler2DArray moverMask;
#ifdef MOVING_SEEN
layout(binding = TOUCHED_UNIT) uniform sampler2D touched;
#else
layout(binding = MOVER_FLAGS_UNIT) uniform usamplerBuffer moverFlags;
#endif

const int LARGEST_WALK = 16;  // texels along a side: a pixel on a silhouette may hold places far apart

bool moverSeen(ivec2 pixel) {
#ifdef MOVING_SEEN
    return texelFetch(touched, pixel, 0).x != 0.0;
#else
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
        if (id != NO_TRIANGLE && texelFetch(moverFlags, int(id)).x != 0u) return true;
    }
    return false;
#endif
}

// Whatever moves over its place counts, before it or behind.
bool moverNear(uint rest) {
    if (isNowhere(rest)) return false;
    ivec2 low = firstCell(rest), high = lastCell(rest);
    int side = int(history.moverMaskSize);
    low = low * side / REST_SIDE;
    ivec2 extent = ((high + 1) * side + REST_SIDE - 1) / REST_SIDE - low;
    if (max(extent.x, extent.y) > LARGEST_WALK) return true;
    float any = 0.0;
    for (int i = 0; i < extent.x * extent.y; ++i) any = max(any, texelFetch(moverMask, ivec3(low + ivec2(i % extent.x, i / extent.x), 0), 0).x);
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
    uint rest = texelFetch(rests, pixel, 0).x, period = rest >> REST_PERIOD_SHIFT;
    vec4 h = texelFetch(past, pixel, 0);
    bool asked = !plausible(h) && !(isNowhere(rest) && h == vec4(0.0));
    if (period != REST_NEVER_ASKED) asked = asked || ((history.round + numberOf(uvec2(pixel) / uint(REST_TILE))) & ((1u << period) - 1u)) < history.framesDue;
#ifdef MOVERS
    asked = asked || moverNear(rest) || moverSeen(pixel);
#endif
    if (!asked) discard;
}
