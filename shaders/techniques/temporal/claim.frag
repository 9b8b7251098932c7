// Claims a texel for a triangle that covers its centre all through the shutter (the coverage map of Hong and Oh 2017,
// with an exact test instead of "both ends cover"): the depth written is the greatest that the triangle has inside the
// texel during the shutter.
#include "lib/covering_triangle.glsl"
#include "lib/cutouts.glsl"

// Farthest corner of the texel on the triangle's plane. Distance is 1 / linear over the map at any time, so that
// corners bound it.
float farthestCorner(vec3 v0, vec3 v1, vec3 v2, vec2 centre, float farthestVertex) {
    float farthest = 0.0;
    for (int i = 0; i < 4; ++i) {
        vec2 corner = centre + (vec2(i & 1, i >> 1) - 0.5) / lightView.size;
        vec3 e = edgeFunctions(seenFrom(corner, v0), seenFrom(corner, v1), seenFrom(corner, v2));
        float distance = dot(e, vec3(v0.z, v1.z, v2.z)) / (e.x + e.y + e.z);
        farthest = distance > 0.0 ? max(farthest, distance) : farthestVertex;
        if (!(distance > 0.0)) break;
    }
    return farthest;
}

void main() {
    vec2 centre = texelCentre();
    precise EdgeQuadratics e = quadraticsOf(seenTriangle(centre));
    if (!coversThroughout(e) || isCutOut(triangleId)) discard;
    float farthest = max(max(max(open0.z, open1.z), max(open2.z, close0.z)), max(close1.z, close2.z));
    // A triangle that only translates has its extremes at the ends of the shutter and at the texel's corners.
    if (nonTranslating == 0u)
        farthest = min(farthest, max(farthestCorner(open0, open1, open2, centre, farthest),
                                     farthestCorner(close0, close1, close2, centre, farthest)));
    farthest *= 1.0 + 1e-4;  // far above rounding
    float depth = ndcDepth(farthest);
#ifdef LIGHT_ORTHOGRAPHIC
    depth -= 1e-6;
#endif
    gl_FragDepth = clamp(depth, 0.0, 1.0);
}
