// The coverage map's second pass as published: where the other end of the nearest triangle's prism covers too, that
// triangle is taken to cover the texel all through the shutter. It need not, and interpolated times may miss 1 by their
// rounding. No depth test; its depth is written.
#include "techniques/temporal/bindings.shared.h"
#include "techniques/temporal/published_prism.glsl"

uniform sampler2DArray nearestMap;

layout(location = 0) out float coverage;

bool overlaps(PrismHits cap, vec2 nearest) { return cap.count > 0 && abs(nearest.y - cap.first.time) >= 1.0; }

void main() {
    vec2 nearest = texelFetch(nearestMap, ivec3(gl_FragCoord.xy, 0), 0).xy;
    if (nearest.x != float(triangleId)) discard;
    PrismHits open = noHits(), close = noHits();
    addFace(open, open0, open1, open2, vec3(0.0));
    addFace(close, close0, close1, close2, vec3(1.0));
    bool closeOverlaps = overlaps(close, nearest);
    if (!closeOverlaps && !overlaps(open, nearest)) discard;
    coverage = float(triangleId);
    gl_FragDepth = clamp(closeOverlaps ? close.first.depth : open.first.depth, 0.0, 1.0);
}
