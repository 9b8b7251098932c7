// Pixels in which a kept answer may be another by now: something that moves is seen in one of its samples, or may come between one of them and
// the light. All others are discarded; what is left lets the technique's own lookup through, by the depth test.
// DYNAMIC_SEEN: there may be such.
#include "lib/blocks.glsl"

#ifdef DYNAMIC_SEEN
uniform sampler2D dynamicPixels;
#endif
uniform sampler2D cachedCells;
uniform usampler2D reachedCells;

const int MAX_WALK = 16;  // cells along a side: a pixel on a silhouette may hold places far apart

bool reached(vec4 bounds) {
    if (bounds.x >= NO_CELL) return false;
    ivec2 low = ivec2(bounds.xy), extent = ivec2(REACHED_SIDE) - ivec2(bounds.zw) - low;
    if (max(extent.x, extent.y) > MAX_WALK) return true;
    uint any = 0u;
    for (int i = 0; i < extent.x * extent.y; ++i) any |= texelFetch(reachedCells, low + ivec2(i % extent.x, i / extent.x), 0).x;
    return any != 0u;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool asked = reached(texelFetch(cachedCells, pixel, 0));
#ifdef DYNAMIC_SEEN
    asked = asked || texelFetch(dynamicPixels, pixel, 0).x != 0.0;
#endif
    if (!asked) discard;
}
