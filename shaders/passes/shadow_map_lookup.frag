// Is the receiver lit, by an ordinary shadow map of one instant? The receiver's point of its triangle is moved to that
// instant as well. PCF_RADIUS: 0 one texel, n the mean over (2n + 1)^2 tests (Reeves et al. 1987).
#include "lib/lookup.glsl"
#include "lib/pcf.glsl"

uniform sampler2DArray shadowMap;
uniform float instant;

float litByTexel(ivec2 texel, float depth) {
    if (!insideMap(texel)) return 1.0;
    return depth > mapDistance(texelFetch(shadowMap, ivec3(texel, 0), 0).x) ? 0.0 : 1.0;
}

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(pointAt(t, r.triangle, r.barycentrics, instant), instant);
    float depth = pcfDepth(m, setting.bias, setting.slope_bias);
    ivec2 texel = ivec2(floor(m.position * lightView.size));
    float lit = 0.0;
    for (int i = 0; i < pcfTests; ++i) lit += litByTexel(texel + pcfOffset(i), depth);
    return lit / float(pcfTests);
}

#include "lib/lookup_main.glsl"
