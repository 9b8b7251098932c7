// Is the receiver lit, by testing every triangle that might shadow it, at its own time and position?
//
// VIEW_CANDIDATES: how many instead, all of those that a lit receiver is tested against: where the first that shadows
// it stands in a list is no property of the scene. DYNAMIC_TRIANGLES, STATIC_TRIANGLES: there are such.
// STATIC_CASTERS_TRAVEL: some of the latter move with the light.
#include "lib/candidate_lists.glsl"
#include "lib/lookup.glsl"
#include "lib/segment_test.glsl"

bool shadows(uint candidate, bool mayMove, Receiver r, vec3 toLight) {
    bool moves = mayMove && (candidate & CANDIDATE_MOVES) != 0u;
    uint id = candidate & ~CANDIDATE_MOVES;
    return segmentMeets(id, fetchMotion(trianglePositions, id, moves), r, toLight);
}

float tested = 0.0;  // candidates of this sample

// Does a candidate of the receiver's cell in bucket `bucket` shadow it?
bool shadowedByList(usamplerBuffer offsets, usamplerBuffer candidates, uint side, uint bucket, bool mayMove, Receiver r,
                    MapPoint m, vec3 toLight) {
    vec2 inGrid = m.position * float(side);
    ivec2 cell = clamp(ivec2(floor(inGrid)), ivec2(0), ivec2(side) - 1);
    uint place = packReceiverPlace(inGrid - vec2(cell), depthStep(m.depth, leastDepth()));
    ivec2 span = listSpan(offsets, int((bucket * side + uint(cell.y)) * side) + cell.x);
    int first = span.x, last = span.y;
    const int together = int(CANDIDATES_TOGETHER);  // as many as a vector holds
    const uint all = (1u << CANDIDATES_TOGETHER) - 1u;
    int entry = first & ~(together - 1);  // the first of those that are looked at next
    uvec4 ids = uvec4(0u);
    uint waiting = 0u;  // of those, which are still to be tested
    bool shadowed = false;
    // Skipping first and testing then keeps neighbouring pixels at the same work (Aila and Laine 2009).
    while (true) {
        while (waiting == 0u && entry < last) {
            int texel = int(uint(entry) / CANDIDATES_TOGETHER * 2u);
            waiting = reachingOf(texelFetch(candidates, texel), place) & (all << uint(max(first - entry, 0))) &
                      (all >> uint(max(entry + together - last, 0)));
            ids = texelFetch(candidates, texel + 1);
            waiting &= ~maskOf(equal(ids & uvec4(~CANDIDATE_MOVES), uvec4(r.triangle)));
            entry += together;
        }
        if (waiting == 0u) break;
        tested += 1.0;
        uint id = (waiting & 1u) != 0u ? ids.x : (waiting & 2u) != 0u ? ids.y : (waiting & 4u) != 0u ? ids.z : ids.w;
#ifndef VIEW_CANDIDATES
        if (shadows(id, mayMove, r, toLight)) {
            shadowed = true;
            break;
        }
#endif
        waiting &= waiting - 1u;
    }
    return shadowed;
}

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    vec3 toLight = segmentToLight(r.position, r.time);
    bool shadowed = false;
    // First dynamic casters, in the receiver's own bucket of time; then static ones.
#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    uint bucket = min(uint(r.time * float(buckets)), buckets - 1u);
    shadowed = shadowedByList(dynamicOffsets, dynamicCandidates, dynamicSide, bucket, true, r, m, toLight);
#endif
#ifdef STATIC_TRIANGLES
    if (!shadowed)
        shadowed = shadowedByList(staticOffsets, staticCandidates, staticSide, 0u, staticCastersTravel, r, m, toLight);
#endif
    return shadowed ? 0.0 : 1.0;
}

#ifdef VIEW_CANDIDATES
uniform float share;  // of a sample in its pixel
layout(location = 0) out float outputTested;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputTested = 0.0;
    if (id == NO_TRIANGLE) return;
    MovingTriangle t = fetchTriangle(id);
    Receiver r = receiverOf(t, id, pixel, stratum);
    if (!facesLight(r)) return;
    litOf(t, r);
    outputTested = tested * share;
}
#else
#include "lib/lookup_main.glsl"
#endif
