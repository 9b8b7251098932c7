// Time-dependent shadow maps: the map's layer of the receiver's own stratum of time, whose texel was drawn at a random
// time of that stratum. The two times differ, by a third of a stratum in the mean: the technique's known error. What stands still in the
// light's frame is in a map of its own.
// DYNAMIC_BIAS: the map's depth is moved along its own velocity to the receiver's time (Andersson 2015, equation 12).
// MOVING_CASTERS: there are such.
#include "lib/lookup.glsl"

layout(binding = TECHNIQUE_UNIT) uniform sampler2DArray depthMap;
layout(binding = TECHNIQUE_UNIT + 2) uniform sampler2DArray stillMap;
#ifdef DYNAMIC_BIAS
layout(binding = TECHNIQUE_UNIT + 1) uniform sampler2DArray velocityMap;
#endif
layout(location = 2) uniform float bias;
layout(location = 3) uniform float slopeBias;

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    ivec2 texel = ivec2(floor(m.position * lightView.size));
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(lightView.size)))) return 1.0;
    float depth = m.depth - depthBias(m, bias, slopeBias);
    float lit = depth > mapDistance(texelFetch(stillMap, ivec3(texel, 0), 0).x) ? 0.0 : 1.0;
#if defined(MOVING_CASTERS) && !defined(STILL_CASTERS_ALONE)
    float casterDepth = mapDistance(texelFetch(depthMap, ivec3(texel, stratum), 0).x);
#ifdef DYNAMIC_BIAS
    float casterTime = sampleTime(frame.timeBase, frame.timeScale, stratum, samplePattern(uvec2(texel), stratum, frame.seed, SALT_LIGHT).z);
    casterDepth += texelFetch(velocityMap, ivec3(texel, stratum), 0).x * (r.time - casterTime);
#endif
    if (depth > casterDepth) lit = 0.0;
#endif
    return lit;
}

#include "lib/lookup_main.glsl"
