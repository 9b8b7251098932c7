// The coverage map's third pass as published: another triangle's prism before the covering one resets the texel.
#include "techniques/temporal/bindings.shared.h"
#include "techniques/temporal/published_prism.glsl"

uniform sampler2DArray nearestMap;  // where the coverage map holds a triangle, it is this one

layout(location = 0) out float coverage;

void main() {
    if (texelFetch(nearestMap, ivec3(gl_FragCoord.xy, 0), 0).x == float(triangleId)) discard;
    PrismHits hits = prismHits();
    if (hits.count == 0) discard;
    coverage = -1.0;
    gl_FragDepth = clamp(hits.nearest.depth, 0.0, 1.0);
}
