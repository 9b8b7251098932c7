// Temporal shadow maps: is a moving triangle between the receiver and the light at the receiver's own time? Of each tuple of the
// texel that holds that time, the distance then is interpolated between the tuple's ends (Hong and Oh 2017, "Lighting pass").
// Still triangles are tested once, in an ordinary map; those that cross the light's near plane one by one, exactly.
// AS_PUBLISHED: the published form's lists. COVERAGE_MAP: with its coverage map.
#include "techniques/temporal/lists.glsl"
#include "lib/near_triangles.glsl"

layout(binding = TUPLE_STILL_UNIT) uniform sampler2DArray stillMap;
layout(location = 0) uniform uint stratum;
layout(location = 2) uniform float bias;
layout(location = 3) uniform float slopeBias;
layout(location = 4) uniform int nearCount;

layout(location = 0) out float outputLit;

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
        if (depth > mapDistance(texelFetch(stillMap, ivec3(texel, 0), 0).x)) return;
        if (nearerThan(depth, texel, id, r.time)) return;
    }
    if (shadowedByNearTriangles(r, nearCount)) return;
    outputLit = 1.0;
}
