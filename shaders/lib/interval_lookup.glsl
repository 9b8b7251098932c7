// The lookup of techniques that list, per texel of the map, when and how far away each triangle is: published, or
// repaired with static triangles in an ordinary map, tested once, and those that cross the light's near plane tested
// one by one, exactly. The technique's file includes lib/lookup.glsl and its lists first, which say
//     bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float u)
//
// STATIC_TRIANGLES, DYNAMIC_TRIANGLES, NEAR_TRIANGLES: there are such. PCF_RADIUS: as in lib/pcf.glsl.
#include "lib/pcf.glsl"

#ifdef STATIC_TRIANGLES
uniform sampler2DArray staticMap;
#endif
#ifdef NEAR_TRIANGLES
#include "lib/near_triangles.glsl"
uniform int nearCount;
#endif

bool shadowedInTexel(MapPoint m, float depth, Receiver r) {
    ivec2 texel;
    if (!texelOf(m, texel)) return false;
#ifdef STATIC_TRIANGLES
    if (depth > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return true;
#endif
#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (nearerThan(m, depth, texel, r.triangle, r.time)) return true;
#endif
    return false;
}

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    float bias = setting.as_published ? setting.published_bias : setting.bias;
    bool unbiased = setting.as_published && bias == 0.0;
    float depth = unbiased ? m.depth : pcfDepth(m, bias, setting.slope_bias), lit = 0.0;
    for (int i = 0; i < pcfTests; ++i)
        lit += shadowedInTexel(movedByTexels(m, pcfOffset(i)), depth, r) ? 0.0 : 1.0;
#if defined(NEAR_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (lit > 0.0 && shadowedByNearTriangles(r, nearCount)) return 0.0;
#endif
    return lit / float(pcfTests);
}

#include "lib/lookup_main.glsl"
