// Intervals in a shadow map: is anything nearer to the light than the receiver, at its own time (Palmér 2011, section
// 2.3.2, "Point sampling": a camera sample has one time).
//
// The depth that is compared is that of the plane of the receiver's triangle through the texel's centre, less a bias:
// where the map looks, a plane surface is never nearer to the light than itself. AS_PUBLISHED: the receiver's own, less
// `published_bias`. Either way the receiver's own triangle is left out.
//
// BILINEAR: four texels are tested, and weighted by how near they are (section 3.2).
// STATIC_TRIANGLES, DYNAMIC_TRIANGLES, NEAR_TRIANGLES: there are such.
#include "lib/lookup.glsl"
#include "lib/receiver_plane.glsl"
#include "techniques/intervals/lists.glsl"

#ifdef STATIC_TRIANGLES
uniform sampler2DArray staticMap;
#endif
#ifdef NEAR_TRIANGLES
#include "lib/near_triangles.glsl"
uniform int nearCount;
#endif

// `place`: of the map, where a triangle that is cut out by its alpha has to cover.
bool shadowedInTexel(ivec2 texel, vec2 place, PlaneInView plane, Receiver r) {
    if (!insideMap(texel)) return false;
#ifdef AS_PUBLISHED
    float depth = plane.depth - setting.published_bias * texelWidth(plane.depth);
#else
    float depth = planeDepth(plane, (vec2(texel) + 0.5) / lightView.size);
    depth -= setting.bias * texelWidth(depth);
#endif
#ifdef STATIC_TRIANGLES
    if (depth > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return true;
#endif
#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (nearerThan(texel, place, depth, r.triangle, r.time)) return true;
#endif
    return false;
}

float litOf(MovingTriangle t, Receiver r) {
#if defined(NEAR_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (shadowedByNearTriangles(r, nearCount)) return 0.0;
#endif
    PlaneInView plane = planeInView(pathInView(t, r.barycentrics), r.time);
    vec2 place = plane.position * lightView.size;
#ifdef BILINEAR
    vec2 corner = floor(place - 0.5), weight = place - 0.5 - corner;
    float lit = 0.0;
    for (int i = 0; i < 4; ++i) {
        ivec2 off = ivec2(i & 1, i >> 1);
        vec2 share = mix(1.0 - weight, weight, vec2(off));
        lit += shadowedInTexel(ivec2(corner) + off, plane.position, plane, r) ? 0.0 : share.x * share.y;
    }
    return min(lit, 1.0);  // weights are rounded
#else
    return shadowedInTexel(ivec2(floor(place)), plane.position, plane, r) ? 0.0 : 1.0;
#endif
}

#include "lib/lookup_main.glsl"
