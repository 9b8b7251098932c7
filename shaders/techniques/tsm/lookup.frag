// Time-dependent shadow maps: the map's layer of the receiver's own stratum of time, whose texel was drawn at a random
// time of that stratum. The two times differ, by a third of a stratum in the mean: the technique's known error.
// Triangles that are static in the light's space are in a map of their own.
//
// DYNAMIC_BIAS: the map's depth is moved to the receiver's time (Andersson, Hasselgren, Munkberg, Akenine-Möller 2015,
// equation 12). BOTH_TIMES: at the rate at which the texel's depth changes, instead of the material point's velocity,
// and the receiver's depth is moved to the map's time as well.
//
// PCF_RADIUS: as in lib/pcf.glsl. DYNAMIC_CASTERS: there are such.
#include "lib/lookup.glsl"
#include "lib/pcf.glsl"
#include "techniques/tsm/layers.glsl"

#ifdef DYNAMIC_BIAS
uniform sampler2DArray velocityMap;
#endif

// `rate`: of the receiver's own depth.
bool shadowedInTexel(MapPoint m, float limit, float rate, float u) {
    ivec2 texel;
    if (!texelOf(m, texel)) return false;
    float atCastersTime = limit;
    uint layer = layerAt(u, stratum);
#ifdef DYNAMIC_BIAS
    float xi = samplePattern(uvec2(texel), frame.firstStratum + layer, frame.seed, SALT_LIGHT).z;
    float later = u - sampleTime(frame.timeBase, layerLength, layer, xi);
#ifdef BOTH_TIMES
    // Two surfaces that do not pass through each other lie in the same order at both times. A curved one that is
    // compared with itself may seem to lie above itself at one of them, where its plane is extrapolated too far, but
    // not at both.
    atCastersTime -= rate * later;
#endif
#endif
    bool shadowed = min(limit, atCastersTime) > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x);
#if defined(DYNAMIC_CASTERS) && !defined(STATIC_CASTERS_ONLY)
    float casterDepth = mapDistance(texelFetch(depthMap, ivec3(texel, layer), 0).x);
    float atReceiversTime = casterDepth;
#ifdef DYNAMIC_BIAS
    atReceiversTime += texelFetch(velocityMap, ivec3(texel, layer), 0).x * later;
#ifndef BOTH_TIMES
    return shadowed || limit > atReceiversTime;
#endif
#endif
    shadowed = shadowed || (limit > atReceiversTime && atCastersTime > casterDepth);
#endif
    return shadowed;
}

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    float limit = pcfDepth(m, setting.bias, setting.slope_bias), rate = 0.0, lit = 0.0;
#ifdef BOTH_TIMES
    rate = mapDepthRate(m, t, r.time);
#endif
    for (int i = 0; i < pcfTests; ++i)
        lit += shadowedInTexel(movedByTexels(m, pcfOffset(i)), limit, rate, r.time) ? 0.0 : 1.0;
    return lit / float(pcfTests);
}

#include "lib/lookup_main.glsl"
