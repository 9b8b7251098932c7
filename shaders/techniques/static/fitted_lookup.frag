// As passes/shadow_map_lookup.frag, against a map that is fitted to what the camera sees.
#include "lib/lookup.glsl"
#include "lib/pcf.glsl"
#include "lib/warped_map.glsl"

uniform sampler2DArray shadowMap;
uniform float instant;
uniform mat3 mapFromPlane;
uniform mat3 planeFromMap;

float litByTexel(WarpedPoint p, ivec2 texel, float depth) {
    if (!insideMap(texel)) return 1.0;
    float inverseWeight;
    planeDepthAtTexel(p, planeFromMap, texel, inverseWeight);
    return depth > mapDistance(texelFetch(shadowMap, ivec3(texel, 0), 0).x / inverseWeight) ? 0.0 : 1.0;
}

float litOf(MovingTriangle t, Receiver r) {
    WarpedPoint p = warpedPointOf(pointAt(t, r.triangle, r.barycentrics, instant), instant, mapFromPlane);
    float depth = pcfDepth(p.m, setting.bias, setting.slope_bias), lit = 0.0;
    ivec2 texel = ivec2(floor(p.texel));
    for (int i = 0; i < pcfTests; ++i) lit += litByTexel(p, texel + pcfOffset(i), depth);
    return lit / float(pcfTests);
}

#include "lib/lookup_main.glsl"
