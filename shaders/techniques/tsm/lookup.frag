// Time-dependent shadow maps: the map's layer of the receiver's own stratum of time, whose texel was drawn at a random
// time of that stratum. The two times differ, by a third of a stratum in the mean: the technique's known error.
// DYNAMIC_BIAS: the map's depth is moved along its own velocity to the receiver's time (Andersson 2015, equation 12).
#include "lib/light_map.glsl"

layout(binding = TECHNIQUE_UNIT) uniform sampler2DArray depthMap;
#ifdef DYNAMIC_BIAS
layout(binding = TECHNIQUE_UNIT + 1) uniform sampler2DArray velocityMap;
#endif
layout(location = 0) uniform uint stratum;
layout(location = 2) uniform float bias;
layout(location = 3) uniform float slopeBias;

layout(location = 0) out float outputLit;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputLit = 1.0;
    if (id == NO_TRIANGLE) return;
    Receiver r = receiverOf(fetchTriangle(id), id, pixel, stratum);
    outputLit = 0.0;
    if (!facesLight(r)) return;
    MapPoint m = mapPointOf(r, r.time);
    outputLit = 1.0;
    ivec2 texel = ivec2(floor(m.position * lightView.size));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(lightView.size)))) return;
    float casterDepth = mapDistance(texelFetch(depthMap, ivec3(texel, stratum), 0).x);
#ifdef DYNAMIC_BIAS
    float casterTime = sampleTime(frame.timeBase, frame.timeScale, stratum, samplePattern(uvec2(texel), stratum, frame.seed, SALT_LIGHT).z);
    casterDepth += texelFetch(velocityMap, ivec3(texel, stratum), 0).x * (r.time - casterTime);
#endif
    outputLit = m.depth - depthBias(m, bias, slopeBias) > casterDepth ? 0.0 : 1.0;
}
