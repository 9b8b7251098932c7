// Pixels whose cached visibility of static receivers by static casters does not suffice in this frame: a dynamic
// triangle is seen in one of their samples, or may come between one of them and the light. All others are discarded;
// those that are left let the technique's own lookup through, by the depth test.
//
// DYNAMIC_SEEN: a mask marks the pixels in which dynamic triangles are seen.
#include "lib/blocks.glsl"

#ifdef DYNAMIC_SEEN
uniform sampler2D dynamicPixels;
#endif
uniform sampler2D cachedCells;
uniform usampler2D reachedCells;

const int MAX_WALK = 16;  // cells along a side: a pixel on a silhouette may hold positions far apart

bool reached(vec4 bounds) {
    if (bounds.x >= NO_CELL) return false;
    ivec2 low = ivec2(bounds.xy), extent = ivec2(REACHED_SIDE) - ivec2(bounds.zw) - low;
    if (max(extent.x, extent.y) > MAX_WALK) return true;
    uint any = 0u;
    for (int i = 0; i < extent.x * extent.y; ++i)
        any |= texelFetch(reachedCells, low + ivec2(i % extent.x, i / extent.x), 0).x;
    return any != 0u;
}

void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    bool changed = reached(texelFetch(cachedCells, pixel, 0));
#ifdef DYNAMIC_SEEN
    changed = changed || texelFetch(dynamicPixels, pixel, 0).x != 0.0;
#endif
    if (!changed) discard;
}
