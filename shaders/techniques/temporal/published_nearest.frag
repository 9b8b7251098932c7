// The coverage map's first pass as published: triangle and time of the nearest fragment of all prisms.
#include "lib/cutouts.glsl"
#include "techniques/temporal/published_prism.glsl"

layout(location = 0) out vec2 nearestMap;

void main() {
    PrismHits hits = prismHits();
    if (hits.count == 0 || isCutOut(triangleId)) discard;     // what is cut out covers nothing for certain
    nearestMap = vec2(float(triangleId), hits.nearest.time);  // as floats: exact up to 2^24 triangles
    gl_FragDepth = clamp(hits.nearest.depth, 0.0, 1.0);
}
