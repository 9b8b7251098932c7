// Depth-time ranges: is a moving triangle between the receiver and the light at the receiver's own time? Of each range of
// the texel that holds that time, the distance then is interpolated between the range's ends (Hong and Oh 2019, section 3.3).
// Still triangles are tested once, in an ordinary map; those that cross the light's near plane one by one, exactly.
// AS_PUBLISHED: the published form's lists. STILL_TRIANGLES, NEAR_TRIANGLES: there are such.
#include "techniques/ranges/lists.glsl"

#ifdef STILL_TRIANGLES
layout(binding = RANGES_STILL_UNIT) uniform sampler2DArray stillMap;
#endif
#ifdef NEAR_TRIANGLES
layout(binding = RANGES_NEAR_UNIT) uniform usamplerBuffer nearTriangles;
layout(location = 4) uniform int nearCount;
#endif
layout(location = 0) uniform uint stratum;
layout(location = 2) uniform float bias;
layout(location = 3) uniform float slopeBias;

layout(location = 0) out float outputLit;

#ifdef NEAR_TRIANGLES
// The definition of shadow itself: does the segment from the receiver to the light meet the triangle, where it is at that time?
bool shadowedByTriangle(uint id, Receiver r) {
    MovingTriangle t = fetchTriangle(id);
    vec3 v0 = mix(t.open0, t.close0, r.time) - r.position, v1 = mix(t.open1, t.close1, r.time) - r.position,
         v2 = mix(t.open2, t.close2, r.time) - r.position;
    vec3 l = towardsLight(r.position, r.time);
    vec3 e = vec3(determinant3(l, v1, v2), determinant3(l, v2, v0), determinant3(l, v0, v1));
    float sum = e.x + e.y + e.z;
    if (!(min(min(e.x, e.y), e.z) >= 0.0 || max(max(e.x, e.y), e.z) <= 0.0) || sum == 0.0) return false;
    float s = determinant3(v0, v1, v2) / sum;
    return s > 1e-5 && s < 1.0;
}

bool shadowedByNearTriangles(Receiver r) {
    for (int i = 0; i < nearCount; ++i) {
        uint id = texelFetch(nearTriangles, i).x;
        if (id != r.triangle && shadowedByTriangle(id, r)) return true;
    }
    return false;
}
#endif

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputLit = 1.0;
    if (id == NO_TRIANGLE) return;
    Receiver r = receiverOf(fetchTriangle(id), id, pixel, stratum);
    outputLit = 0.0;
    if (!facesLight(r)) return;
    MapPoint m = mapPointOf(r, r.time);
    ivec2 texel;
    if (texelOf(m, texel)) {
        float depth = m.depth - depthBias(m, bias, slopeBias);
#ifdef STILL_TRIANGLES
        if (depth > mapDistance(texelFetch(stillMap, ivec3(texel, 0), 0).x)) return;
#endif
        if (nearerThan(m, depth, texel, id, r.time)) return;
    }
#ifdef NEAR_TRIANGLES
    if (shadowedByNearTriangles(r)) return;
#endif
    outputLit = 1.0;
}
