// Depth-time ranges: is a moving triangle between the receiver and the light at the receiver's own time? For each range
// of the texel that holds that time, the distance then is interpolated between the range's ends (Hong and Oh 2019,
// section 3.3). Static triangles are tested once, in an ordinary map; those that cross the light's near plane one by
// one, exactly.
//
// AS_PUBLISHED: the published form's lists. STATIC_TRIANGLES, DYNAMIC_TRIANGLES, NEAR_TRIANGLES: there are such.
#include "lib/lookup.glsl"
#include "techniques/ranges/lists.glsl"

#ifdef STATIC_TRIANGLES
uniform sampler2DArray staticMap;
#endif
#ifdef NEAR_TRIANGLES
#include "lib/near_triangles.glsl"
uniform int nearCount;
#endif

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    ivec2 texel;
    if (texelOf(m, texel)) {
        float depth = m.depth - depthBias(m, setting.bias, setting.slope_bias);
#ifdef STATIC_TRIANGLES
        if (depth > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return 0.0;
#endif
#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
        if (nearerThan(m, depth, texel, r.triangle, r.time)) return 0.0;
#endif
    }
#if defined(NEAR_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (shadowedByNearTriangles(r, nearCount)) return 0.0;
#endif
    return 1.0;
}

#include "lib/lookup_main.glsl"
