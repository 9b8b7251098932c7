// The definition of shadow, tested for one triangle at the receiver's own time (docs/numerics.md, "Definition of
// shadow"): does the segment from the receiver towards the light meet it?
#include "lib/cutouts.glsl"
#include "lib/receiver.glsl"
#include "shared/segment_triangle.shared.h"

// Where casters are looked for: as far as the light, or as deep as the map of a directional one.
vec3 segmentToLight(vec3 position, float u) {
    vec3 toLight = towardsLight(position, u);
#ifdef LIGHT_ORTHOGRAPHIC
    toLight *= lightView.farDistance;
#endif
    return toLight;
}

// The vertices at time u, seen from the receiver.
struct SeenVertices {
    vec3 v0, v1, v2;
};

SeenVertices seenVertices(VertexMotion v, vec3 position, float u) {
    return SeenVertices(vertexFromReceiver(v.open0, v.close0, u, position),
                        vertexFromReceiver(v.open1, v.close1, u, position),
                        vertexFromReceiver(v.open2, v.close2, u, position));
}

// Does triangle `id` cover where the line towards the light meets it?
bool coversLine(uint id, SeenVertices seen, vec3 toLight) {
    return cutoutCovers(id, vec3(edgeSide(toLight, seen.v1, seen.v2), edgeSide(toLight, seen.v2, seen.v0),
                                 edgeSide(toLight, seen.v0, seen.v1)));
}

// `v`: of triangle `id`.
bool segmentMeets(uint id, VertexMotion v, Receiver r, vec3 toLight) {
    SeenVertices seen = seenVertices(v, r.position, r.time);
    return segmentMeetsTriangle(toLight, seen.v0, seen.v1, seen.v2, r.clearance) && coversLine(id, seen, toLight);
}
