// Time-dependent shadow maps: the map's layer of the receiver's own stratum of time, whose texel was drawn at a random
// time of that stratum. The two times differ, by a third of a stratum in the mean: the technique's known error.
// Triangles that are static in the light's space are in a map of their own.
//
// DYNAMIC_BIAS: the two are compared at both times. The map's depth is moved to the receiver's time (Andersson,
// Nilsson, Munkberg, Hasselgren and Akenine-Möller 2015, equation 12, with the rate at which the texel's depth changes
// instead of the material point's velocity), and the receiver's to the map's.
//
// DYNAMIC_CASTERS: there are such.
#include "lib/lookup.glsl"

uniform sampler2DArray depthMap;
uniform sampler2DArray staticMap;
#ifdef DYNAMIC_BIAS
uniform sampler2DArray velocityMap;
#endif

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    ivec2 texel;
    if (!texelOf(m, texel)) return 1.0;
    float limit = m.depth - depthBias(m, setting.bias, setting.slope_bias), atCastersTime = limit;
#ifdef DYNAMIC_BIAS
    // Two surfaces that do not pass through each other lie in the same order at both times. A curved one that is
    // compared with itself may seem to lie above itself at one of them, where its plane is extrapolated too far, but
    // not at both.
    float xi = samplePattern(uvec2(texel), stratum, frame.seed, SALT_LIGHT).z;
    float later = r.time - sampleTime(frame.timeBase, frame.timeScale, stratum, xi);
    atCastersTime -= mapDepthRate(m, t, r.time) * later;
#endif
    bool shadowed = min(limit, atCastersTime) > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x);
#if defined(DYNAMIC_CASTERS) && !defined(STATIC_CASTERS_ONLY)
    float casterDepth = mapDistance(texelFetch(depthMap, ivec3(texel, stratum), 0).x);
    float atReceiversTime = casterDepth;
#ifdef DYNAMIC_BIAS
    atReceiversTime += texelFetch(velocityMap, ivec3(texel, stratum), 0).x * later;
#endif
    shadowed = shadowed || (limit > atReceiversTime && atCastersTime > casterDepth);
#endif
    return shadowed ? 0.0 : 1.0;
}

#include "lib/lookup_main.glsl"
