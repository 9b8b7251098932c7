// The shadow map test of a surface point, and its confidence.
//
// TRIES_TRIANGLES: the triangles that the map saw are tested against the point's own ray as well.
#include "lib/segment_test.glsl"
#include "lib/warped_map.glsl"
#include "techniques/history/blocks.glsl"

uniform sampler2DArray shadowMap;
#ifdef TRIES_TRIANGLES
uniform usampler2DArray mapTriangles;
#endif

struct ShadowTest {
    float lit;         // 0, 1, or the mean over the texels of the filter
    float confidence;  // equation 5; 0 outside the map
    bool proven;       // shadowed by a triangle that the segment to the light was found to meet
    bool sure;         // proven, or nothing around that might shadow the point
    bool guessedDark;  // lit, if later frames can still find a triangle that shadows it; else better taken to be
                       // shadowed
    vec2 place;        // in the light's image plane
    float depth;       // distance from the light's plane
};

#ifdef TRIES_TRIANGLES
struct Trial {
    bool met;      // by the segment from the receiver to the light
    bool open;     // it would be, were it not cut out there by its alpha
    float height;  // the least of the triangle's heights seen from the receiver, in texels
};

Trial tryTriangle(uint id, Receiver r, float u, vec3 toLight, float texel) {
    SeenVertices seen = seenVertices(fetchMotion(trianglePositions, id, true), r.position, u);
    vec3 v0 = seen.v0, v1 = seen.v1, v2 = seen.v2;
    Trial trial = Trial(segmentMeetsTriangle(toLight, v0, v1, v2, r.clearance), false, 0.0);
#ifdef CUTOUTS
    trial.open = trial.met && !coversLine(id, seen, toLight);
    trial.met = trial.met && !trial.open;
#endif
    if (trial.met || trial.open) return trial;
    vec3 way = normalize(toLight);
    vec3 edge0 = cross(way, v2 - v1), edge1 = cross(way, v0 - v2), edge2 = cross(way, v1 - v0);
    float longest = sqrt(max(dot(edge0, edge0), max(dot(edge1, edge1), dot(edge2, edge2))));
    trial.height = abs(dot(edge1, v2 - v1)) / max(longest * texel, 1e-30);
    return trial;
}

// Beyond the paper: the triangles that the four texels around the receiver saw are tested against the receiver's own
// segment to the light. One that it meets proves that the receiver is shadowed, wherever the texel's centre lies. Where
// none is met, though not all four texels see something nearer than the receiver's plane, an edge of a shadow runs by,
// and a texel that sees a caster says nothing about this point. If frames follow without motion, whatever is shadowed
// will be proven so. Else a caster of at least a texel's height is known to end here; behind a smaller one, which may
// continue in a triangle that no texel saw, the point is taken to be shadowed.
ShadowTest tryTriangles(Receiver r, float u, WarpedPoint p) {
    ivec2 nearest = ivec2(floor(p.texel)), corner = ivec2(floor(p.texel - 0.5));
    bool inside = insideMap(nearest);
    ShadowTest test = ShadowTest(1.0, inside ? shadowTestConfidence(p.texel) : 0.0, false, true, false,
                                 p.plane.position, p.plane.depth);
    vec3 place = vec3((vec2(corner) + 1.0) / lightView.size, 0.0);
    uvec4 triangles = textureGather(mapTriangles, place);
    // No triangle shadows its own points: most lit receivers end here.
    if (all(equal(triangles, uvec4(r.triangle)))) return test;
    vec4 stored = textureGather(shadowMap, place);
    vec3 toLight = segmentToLight(r.position, u);
    // The nearest first, in gather's order: (0, 1), (1, 1), (1, 0), (0, 0).
    ivec2 offset = nearest - corner;
    int first = offset.y == 1 ? offset.x : 3 - offset.x;
    uint nearer = 0u, last = NO_TRIANGLE;
    bool dark = false, open = false;
    for (int k = 0; k < 4; ++k) {
        int i = first ^ k;
        uint id = triangles[i];
        if (id == NO_TRIANGLE || id == r.triangle) continue;
        ivec2 texel = corner + ivec2(i == 1 || i == 2 ? 1 : 0, i < 2 ? 1 : 0);
        float inverseWeight;
        float before = planeDepthAtTexel(p, mat3(history.planeFromMap), texel, inverseWeight),
              caster = mapDistance(stored[i] / inverseWeight);
        before -= caster;
        // An exact test needs no bias, so that contacts are right.
        if (before <= 0.0) continue;
        bool counts = before > setting.bias * p.m.texel;
        if (counts) {
            ++nearer;
            test.sure = false;
        }
        // Light comes through it here, whatever is behind.
        if (id == last && open && counts) --nearer;
        if (id == last) continue;
        last = id;
#ifdef LIGHT_ORTHOGRAPHIC
        float width = p.m.texel;
#else
        float width = p.m.texel * caster / p.plane.depth;
#endif
        Trial trial = tryTriangle(id, r, u, toLight, width);
        if (trial.met) return ShadowTest(0.0, 1.0, true, true, false, p.plane.position, p.plane.depth);
        open = trial.open;
        if (open && counts) --nearer;
        if (!open && k == 0 && nearer == 1u && trial.height < 1.0) dark = true;
    }
    test.guessedDark = inside && dark;
    if (inside && (nearer == 4u || (dark && history.awaitsProof == 0u))) test.lit = 0.0;
    return test;
}
#else
const float DEPTH_ROUNDING = 1.0 / 131072.0;  // 2^-17: some sixty units in a float's last place

float litByTexel(WarpedPoint p, ivec2 texel, float publishedDepth) {
    if (!insideMap(texel)) return 1.0;
    float inverseWeight;
    float planeDepth =
        planeDepthAtTexel(p, mat3(history.planeFromMap), texel, inverseWeight) - setting.bias * p.m.texel;
    float caster = mapDistance(texelFetch(shadowMap, ivec3(texel, 0), 0).x / inverseWeight);
    // What is as far as the map's surface is not behind it, whatever rounding makes of a warped depth.
    if (setting.as_published) return publishedDepth > caster * (1.0 + DEPTH_ROUNDING) ? 0.0 : 1.0;
    return planeDepth > caster ? 0.0 : 1.0;
}
#endif

ShadowTest testShadow(Receiver r, float u) {
    WarpedPoint p = warpedPointOf(r, u, mat3(history.mapFromPlane));
#ifdef TRIES_TRIANGLES
    return tryTriangles(r, u, p);
#else
    ivec2 texel = ivec2(floor(p.texel));
    int radius = int(setting.pcf_radius);
    float publishedDepth = p.m.depth;  // no bias is published
    if (setting.published_bias > 0.0)
        publishedDepth -= depthBias(p.m, setting.published_bias, setting.slope_bias * float(2 * radius + 1));
    ShadowTest test;
    test.proven = test.sure = test.guessedDark = false;
    test.place = p.plane.position;
    test.depth = p.plane.depth;
    test.lit = 0.0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) test.lit += litByTexel(p, texel + ivec2(x, y), publishedDepth);
    test.lit /= float((2 * radius + 1) * (2 * radius + 1));
    test.confidence = insideMap(texel) ? shadowTestConfidence(p.texel) : 0.0;
    return test;
#endif
}
