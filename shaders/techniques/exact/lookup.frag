// Is the receiver lit, by testing every triangle that might shadow it, at its own time and place? VIEW_CANDIDATES: how many
// were tested instead.
#include "lib/light_map.glsl"
#include "shared/candidate_bounds.shared.h"
#include "shared/segment_triangle.shared.h"

layout(binding = TECHNIQUE_UNIT) uniform usamplerBuffer offsets;
layout(binding = TECHNIQUE_UNIT + 1) uniform usamplerBuffer candidates;  // triangle, where it is
layout(location = 0) uniform uint stratum;
layout(location = 1) uniform uint gridSide;
layout(location = 2) uniform uint buckets;
#ifdef VIEW_CANDIDATES
layout(location = 3) uniform float share;  // of a sample in its pixel
#endif

layout(location = 0) out float outputLit;

bool shadows(uint candidate, Receiver r, vec3 toLight) {
    int first = int(candidate & ~CANDIDATE_MOVES) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(trianglePositions, first), b = texelFetch(trianglePositions, first + 1),
         c = texelFetch(trianglePositions, first + 2);
    vec3 open0 = a.xyz, open1 = vec3(a.w, b.xy), open2 = vec3(b.zw, c.x);
    vec3 close0 = open0, close1 = open1, close2 = open2;
    if ((candidate & CANDIDATE_MOVES) != 0u) {
        vec4 d = texelFetch(trianglePositions, first + 3);
        close0 = c.yzw;
        close1 = d.xyz;
        close2 = vec3(d.w, texelFetch(trianglePositions, first + 4).xy);
    }
    return segmentMeetsTriangle(toLight, vertexFromReceiver(open0, close0, r.time, r.position), vertexFromReceiver(open1, close1, r.time, r.position),
                                vertexFromReceiver(open2, close2, r.time, r.position), 0.0);
}

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
#ifdef VIEW_CANDIDATES
    outputLit = 0.0;
#else
    outputLit = 1.0;
#endif
    if (id == NO_TRIANGLE) return;
    Receiver r = receiverOf(fetchTriangle(id), id, pixel, stratum);
    outputLit = 0.0;
    if (!facesLight(r)) return;
    MapPoint m = mapPointOf(r, r.time);
    vec3 toLight = towardsLight(r.position, r.time);
#ifdef LIGHT_ORTHOGRAPHIC
    toLight *= lightView.farDistance;
#endif
    vec2 inGrid = m.position * float(gridSide);
    ivec2 cell = clamp(ivec2(floor(inGrid)), ivec2(0), ivec2(gridSide) - 1);
    uvec2 place = uvec2(clamp(floor((inGrid - vec2(cell)) * 16.0), vec2(0.0), vec2(15.0)));
    uint cells = gridSide * gridSide, list = uint(cell.y) * gridSide + uint(cell.x);
    uint bucket = min(uint(r.time * float(buckets)), buckets - 1u);
    float tested = 0.0, lit = 1.0;
    // First what moves, in the receiver's own bucket of time; then what stands still.
    for (uint pass = 0u; pass < 2u; ++pass) {
        int offset = int((pass == 0u ? bucket : buckets) * cells + list);
        int i = int(texelFetch(offsets, offset).x), last = lit > 0.0 ? int(texelFetch(offsets, offset + 1).x) : 0;
        // Skipping first and testing then keeps neighbouring pixels at the same work (Aila and Laine 2009).
        while (i < last) {
            uvec2 candidate = uvec2(id, 0u);
            bool reaches = false;
            while (i < last && !reaches) {
                candidate = texelFetch(candidates, i++).xy;
                reaches = candidateReaches(candidate.y, place, m.depth) && (candidate.x & ~CANDIDATE_MOVES) != id;
            }
            if (!reaches) break;
            tested += 1.0;
            if (shadows(candidate.x, r, toLight)) {
                lit = 0.0;
                break;
            }
        }
    }
#ifdef VIEW_CANDIDATES
    outputLit = tested * share;
#else
    outputLit = lit;
#endif
}
