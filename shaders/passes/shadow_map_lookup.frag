// Is the receiver lit, by an ordinary shadow map of one instant? The receiver's own point of its surface is taken
// to that instant as well. PCF_RADIUS: 0 one texel, n the mean over (2n + 1)^2 tests (Reeves et al. 1987).
#include "lib/light_map.glsl"

layout(binding = TECHNIQUE_UNIT) uniform sampler2DArray shadowMap;
layout(location = 0) uniform uint stratum;
layout(location = 1) uniform float instant;
layout(location = 2) uniform float bias;
layout(location = 3) uniform float slopeBias;

layout(location = 0) out float outputLit;

float litByTexel(ivec2 texel, float depth) {
    ivec2 last = ivec2(lightView.size) - 1;
    if (any(lessThan(texel, ivec2(0))) || any(greaterThan(texel, last))) return 1.0;
    return depth > mapDistance(texelFetch(shadowMap, ivec3(texel, 0), 0).x) ? 0.0 : 1.0;
}

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputLit = 1.0;
    if (id == NO_TRIANGLE) return;
    MovingTriangle t = fetchTriangle(id);
    Receiver r = receiverOf(t, id, pixel, stratum);
    outputLit = 0.0;
    if (!facesLight(r)) return;
    MapPoint m = mapPointOf(pointAt(t, id, r.barycentrics, instant), instant);
    float depth = m.depth - depthBias(m, bias, slopeBias * float(2 * PCF_RADIUS + 1));
    ivec2 texel = ivec2(floor(m.position * lightView.size));
    for (int y = -PCF_RADIUS; y <= PCF_RADIUS; ++y)
        for (int x = -PCF_RADIUS; x <= PCF_RADIUS; ++x) outputLit += litByTexel(texel + ivec2(x, y), depth);
    outputLit /= float((2 * PCF_RADIUS + 1) * (2 * PCF_RADIUS + 1));
}
