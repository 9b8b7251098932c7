// Shadow maps of fixed times (ours; docs/numerics.md, "Fixed times"): the texels of a block of PATTERN x PATTERN have
// as many times of the slice, its phases. The receiver is taken to each, as a point of its triangle, tested there in
// the phase's texel that is nearest to it, and the tests are averaged: casters and receiver are seen at the same times.
//
// PLANE_TEST: against the depth of the receiver's plane at the texel's centre. OWN_STRATA: the map's slices are not
// the strata of the camera samples; those that overlap the sample's count by how much they do. PCF_RADIUS: as in
// lib/pcf.glsl, among texels of one phase. STATIC_CASTERS, DYNAMIC_CASTERS: there are such.
#include "lib/lookup.glsl"
#include "lib/pcf.glsl"
#include "lib/receiver_plane.glsl"
#include "shared/shutter_response.shared.h"

#ifdef STATIC_CASTERS
uniform sampler2DArray staticMap;
uniform usampler2DArray staticTriangles;
#endif
#ifdef DYNAMIC_CASTERS
uniform sampler2DArray depthMap;
uniform usampler2DArray triangleMap;
#endif
#ifdef OWN_STRATA
uniform uint layers;
uniform float layerLength;  // u
#endif

const uint phases = uint(PATTERN) * uint(PATTERN);

// The texel of a phase whose centre is nearest; at the map's border the next one inside, if there is one.
ivec2 nearestTexel(vec2 position, uint phase) {
    ivec2 first = ivec2(phase % uint(PATTERN), phase / uint(PATTERN));
    vec2 blocks = (position * lightView.size - 0.5 - vec2(first)) / float(PATTERN);
    ivec2 texel = first + PATTERN * ivec2(floor(blocks + 0.5));
    ivec2 beyond = ivec2(greaterThanEqual(texel, ivec2(lightView.size))) - ivec2(lessThan(texel, ivec2(0)));
    return texel - PATTERN * beyond;
}

// The receiver's own triangle is left out. Where its plane is tested it is so without a look at its number: it is as
// far as its plane, and its plane is farther than the limit.
#ifdef PLANE_TEST
#define isOwn(triangles, layer) false
#else
#define isOwn(triangles, layer) (texelFetch(triangles, ivec3(texel, layer), 0).x == own)
#endif

bool shadowedInTexel(PlaneInView p, ivec2 texel, uint own, uint layer) {
    if (!insideMap(texel)) return false;
#ifdef PLANE_TEST
    float depth = planeDepth(p, (vec2(texel) + 0.5) / lightView.size);
#else
    float depth = p.depth;
#endif
    float limit = depth - setting.bias * texelWidth(depth);
    bool shadowed = false;
#ifdef STATIC_CASTERS
    shadowed = limit > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x) && !isOwn(staticTriangles, 0);
#endif
#ifdef DYNAMIC_CASTERS
    float casterDepth = mapDistance(texelFetch(depthMap, ivec3(texel, layer), 0).x);
    shadowed = shadowed || (limit > casterDepth && !isOwn(triangleMap, layer));
#endif
    return shadowed;
}

float litInPhase(PlaneInView p, uint own, uint phase, uint layer) {
    ivec2 texel = ivec2(floor(p.position * lightView.size));
    if (!insideMap(texel)) return 1.0;
    texel = nearestTexel(p.position, phase);
    int lit = 0;
    for (int i = 0; i < pcfTests; ++i)
        lit += shadowedInTexel(p, texel + PATTERN * pcfOffset(i), own, layer) ? 0 : 1;
    return float(lit) / float(pcfTests);
}

// Weighted tests of a receiver, of those phases at which it faces the light, and of all.
struct Tests {
    float lit, sum;
    float litOfAll, sumOfAll;
};

// The phases of a slice, which begins at u0 and counts by `share`. `side`: PlaneInView::towards where it is seen.
void addSlice(inout Tests tests, PathInView path, Receiver r, float side, uint layer, float u0, float length,
              float share) {
    for (uint phase = 0u; phase < phases; ++phase) {
        float u = sampleTime(u0, length, 0u, phaseTime(phase, uint(PATTERN)));
        PlaneInView p = planeInView(path, u);
        float weight = share * shutterWeight(frame.response, frame.responseWidth, u);
        float lit = weight * litInPhase(p, r.triangle, phase, layer);
        tests.litOfAll += lit;
        tests.sumOfAll += weight;
        if (p.towards * side <= 0.0) continue;
        tests.lit += lit;
        tests.sum += weight;
    }
}

float litOver(MovingTriangle t, Receiver r, float u0, float u1) {
    PathInView path = pathInView(t, r.barycentrics);
    float side = planeInView(path, r.time).towards;
    Tests tests = Tests(0.0, 0.0, 0.0, 0.0);
#ifdef OWN_STRATA
    // A slice that only rounding lets begin before the end does not count.
    float slack = layerLength / 64.0;
    uint first = layerLength > 0.0 ? uint((u0 + slack - frame.timeBase) / layerLength) : 0u;
    for (uint layer = first; layer < layers; ++layer) {
        float begin = frame.timeBase + float(layer) * layerLength, end = begin + layerLength;
        float share = layerLength > 0.0 ? min(end, u1) - max(begin, u0) : 1.0;
        if (layer > first && share < slack) break;
        addSlice(tests, path, r, side, layer, begin, layerLength, share);
        if (layerLength == 0.0) break;
    }
#else
    addSlice(tests, path, r, side, stratum, u0, u1 - u0, 1.0);
#endif
    return tests.sum > 0.0 ? tests.lit / tests.sum : tests.litOfAll / tests.sumOfAll;
}

#include "lib/lookup_main.glsl"
