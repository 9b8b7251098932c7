// Intervals in a shadow map: is anything nearer to the light than the receiver, at its own time (Palmér 2011, section
// 2.3.2, "Point sampling": a camera sample has one time), or for how long of an interval (sections 2.3.1 and 2.3.2).
//
// The depth that is compared is that of the plane of the receiver's triangle through the texel's centre, less a bias:
// where the map looks, a plane surface is never nearer to the light than itself. AS_PUBLISHED: the receiver's own, less
// `published_bias`. Either way the receiver's own triangle is left out.
//
// BILINEAR: four texels are tested, and weighted by how near they are (section 3.2).
// STATIC_TRIANGLES, DYNAMIC_TRIANGLES, NEAR_TRIANGLES: there are such.
#include "lib/lookup.glsl"
#include "lib/receiver_plane.glsl"
#include "lib/segment_test.glsl"
#include "techniques/intervals/lists.glsl"

#ifdef STATIC_TRIANGLES
uniform sampler2DArray staticMap;
#endif
#ifdef NEAR_TRIANGLES
#include "lib/near_triangles.glsl"
uniform int nearCount;
#endif

// What the entries of a texel are compared with.
float comparedDepth(ivec2 texel, PlaneInView plane) {
#ifdef AS_PUBLISHED
    return plane.depth - setting.published_bias * texelWidth(plane.depth);
#else
    float depth = planeDepth(plane, (vec2(texel) + 0.5) / lightView.size);
    return depth - setting.bias * texelWidth(depth);
#endif
}

bool shadowedInTexel(ivec2 texel, PlaneInView plane, uint own, float time) {
    if (!insideMap(texel)) return false;
    float depth = comparedDepth(texel, plane);
#ifdef STATIC_TRIANGLES
    if (depth > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return true;
#endif
#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (nearerThan(texel, plane.position, depth, own, time)) return true;
#endif
    return false;
}

// The texels that are tested at a place, in texels: one, or four with their weights.
#ifdef BILINEAR
const int taps = 4;
const float firstTap = 0.5;
#else
const int taps = 1;
const float firstTap = 0.0;
#endif

ivec2 cellAt(vec2 place) { return ivec2(floor(place - firstTap)); }
ivec2 tapOf(ivec2 cell, int i) { return cell + ivec2(i & 1, i >> 1); }

float weightOf(ivec2 cell, vec2 place, int i) {
#ifdef BILINEAR
    vec2 weight = clamp(place - 0.5 - vec2(cell), 0.0, 1.0);
    vec2 share = mix(1.0 - weight, weight, vec2(i & 1, i >> 1));
    return share.x * share.y;
#else
    return 1.0;
#endif
}

float litInMap(PlaneInView plane, uint own, float time) {
    vec2 place = plane.position * lightView.size;
    ivec2 cell = cellAt(place);
    float lit = 0.0;
    for (int i = 0; i < taps; ++i)
        lit += shadowedInTexel(tapOf(cell, i), plane, own, time) ? 0.0 : weightOf(cell, place, i);
    return min(lit, 1.0);  // weights are rounded
}

float litOf(MovingTriangle t, Receiver r) {
#if defined(NEAR_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    if (shadowedByNearTriangles(r, nearCount)) return 0.0;
#endif
    return litInMap(planeInView(pathInView(t, r.barycentrics), r.time), r.triangle, r.time);
}

#ifdef SOLVES_INTERVALS
#include "techniques/intervals/along.glsl"
#endif
#include "lib/lookup_main.glsl"
