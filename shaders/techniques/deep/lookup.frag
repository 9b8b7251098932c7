// Deep shadow maps: the receiver's depth, at its own time, in the visibility function of its texel. What stands still
// in the light's frame is in a map of its own: whatever lies behind that is dark, and before it there is only what
// moves.
//
// PCF_RADIUS: as in lib/pcf.glsl. DYNAMIC_CASTERS: there are such.
#include "lib/lookup.glsl"
#include "lib/pcf.glsl"
#if defined(DYNAMIC_CASTERS) && !defined(STATIC_CASTERS_ONLY)
#define VISIBILITY_FUNCTIONS
#include "techniques/deep/nodes.glsl"
#endif

uniform sampler2DArray staticMap;

float visibilityInTexel(MapPoint m, float depth) {
    ivec2 texel;
    if (!texelOf(m, texel)) return 1.0;
    if (depth > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return 0.0;
#ifdef VISIBILITY_FUNCTIONS
    return visibilityAt(texel, depth);
#else
    return 1.0;
#endif
}

// The functions are about the whole shutter, whatever the time: the receiver is not followed.
float litOver(MovingTriangle t, Receiver r, float u0, float u1) {
    MapPoint m = mapPointOf(r, r.time);
    float depth = pcfDepth(m, setting.bias, setting.slope_bias), lit = 0.0;
    for (int i = 0; i < pcfTests; ++i) lit += visibilityInTexel(movedByTexels(m, pcfOffset(i)), depth);
    return lit / float(pcfTests);
}

#include "lib/lookup_main.glsl"
