// Triangles that cross the light's near plane have no projection that a map could hold: each sample tests them one by one.
#include "lib/receiver.glsl"

uniform usamplerBuffer nearTriangles;

// The definition of shadow itself: does the segment from the receiver to the light meet the triangle where it is at that time?
bool shadowedByTriangle(uint id, Receiver r) {
    MovingTriangle t = fetchTriangle(id);
    // Less the receiver first: full precision near contacts.
    vec3 v0 = mix(t.open0, t.close0, r.time) - r.position, v1 = mix(t.open1, t.close1, r.time) - r.position,
         v2 = mix(t.open2, t.close2, r.time) - r.position;
    vec3 l = towardsLight(r.position, r.time);
    vec3 e = vec3(determinant3(l, v1, v2), determinant3(l, v2, v0), determinant3(l, v0, v1));
    float sum = e.x + e.y + e.z;
    bool through = min(min(e.x, e.y), e.z) >= 0.0 || max(max(e.x, e.y), e.z) <= 0.0;
    if (!through || sum == 0.0) return false;
    float s = determinant3(v0, v1, v2) / sum;
    return s > 1e-5 && s < 1.0;
}

bool shadowedByNearTriangles(Receiver r, int count) {
    for (int i = 0; i < count; ++i) {
        uint id = texelFetch(nearTriangles, i).x;
        if (id != r.triangle && shadowedByTriangle(id, r)) return true;
    }
    return false;
}
