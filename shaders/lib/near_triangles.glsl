// Triangles that cross the light's near plane have no projection that a map could hold: each sample tests them one by
// one, exactly.
#include "lib/segment_test.glsl"

uniform usamplerBuffer nearTriangles;

bool shadowedByNearTriangles(Receiver r, int count) {
    vec3 toLight = segmentToLight(r.position, r.time);
    for (int i = 0; i < count; ++i) {
        uint id = texelFetch(nearTriangles, i).x;
        if (id != r.triangle && segmentMeets(id, fetchMotion(trianglePositions, id, true), r, toLight)) return true;
    }
    return false;
}
