#ifdef __cplusplus
#pragma once
#endif
#include "shared/swept_bounds.shared.h"

SHARED_BEGIN

/// How far float arithmetic may put a point of the light's map from where it is, in map widths: receivers and casters get
/// there by the same matrices, each with an error of a few units of 2^-24 of the scene's extent over the distance.
#define MAP_POSITION_SLACK SHARED_FLOAT(1e-5)

/// Set in a candidate's triangle number when the triangle moves in the world: its second position must be read.
#define CANDIDATE_MOVES 0x80000000u

/// Where in its cell, and how near at the least, a candidate is, in one word: four bits for each side of its bounds, in
/// sixteenths of the cell and inclusive, and the upper 16 bits of the depth as a float (truncated, so never farther than it is; a
/// depth below 0 counts as 0). Bounds in cells, relative to the cell's low corner.
SHARED_FUNCTION uint packCandidateBounds(vec2 low, vec2 high, float nearest) {
    uvec2 first = uvec2(clamp(floor(low * SHARED_FLOAT(16.0)), vec2(0), vec2(15)));
    uvec2 last = uvec2(clamp(floor(high * SHARED_FLOAT(16.0)), vec2(0), vec2(15)));
    return (floatBitsToUint(max(nearest, SHARED_FLOAT(0.0))) & 0xffff0000u) | (first.x << 12u) | (first.y << 8u) | (last.x << 4u) | last.y;
}

/// Can the candidate shadow a receiver at `place` (sixteenths of the cell, 0 .. 15) and `depth`? False only where it can't.
SHARED_FUNCTION bool candidateReaches(uint bounds, uvec2 place, float depth) {
    return uintBitsToFloat(bounds & 0xffff0000u) <= depth && place.x >= ((bounds >> 12u) & 15u) && place.y >= ((bounds >> 8u) & 15u) &&
           place.x <= ((bounds >> 4u) & 15u) && place.y <= (bounds & 15u);
}

/// A moving triangle's three edges as the light sees them during an interval. Seen through the map position p, edge k has the
/// function e_k(u, p) = (V_i(u) x V_j(u)) . (p, 1) with V = (X, Y, Z), or (X, Y, 1) when orthographic: a quadratic in u whose Bernstein
/// coefficients are linear in p. p is inside at u iff the three e_k have one sign.
struct EdgeSweep {
    vec3 first, middle, last;  // Bernstein coefficients of V_i x V_j
};

SHARED_FUNCTION EdgeSweep edgeSweep(vec3 aOpen, vec3 bOpen, vec3 aClose, vec3 bClose) {
    EdgeSweep sweep;
    sweep.first = cross(aOpen, bOpen);
    sweep.middle = SHARED_FLOAT(0.5) * (cross(aOpen, bClose) + cross(aClose, bOpen));
    sweep.last = cross(aClose, bClose);
    return sweep;
}

/// Least (x) and greatest (y) value that the edge function may have anywhere in the square of half width `reach` around
/// `centre`, at any time of the interval: a quadratic lies between its Bernstein coefficients. Widened by its own rounding.
SHARED_FUNCTION vec2 edgeRange(EdgeSweep sweep, vec2 centre, float reach) {
    vec3 point = vec3(centre, 1);
    vec3 magnitude = vec3(abs(centre) + vec2(reach), 1);
    float first = dot(sweep.first, point), middle = dot(sweep.middle, point), last = dot(sweep.last, point);
    vec3 slack = SHARED_FLOAT(1e-6) * magnitude + vec3(reach, reach, 0);
    float firstReach = dot(abs(sweep.first), slack), middleReach = dot(abs(sweep.middle), slack), lastReach = dot(abs(sweep.last), slack);
    return vec2(min(min(first - firstReach, middle - middleReach), last - lastReach),
                max(max(first + firstReach, middle + middleReach), last + lastReach));
}

/// Can the triangle cover no point of the square throughout the interval? False where in doubt. If one edge function is negative all
/// over it and another positive, no sign is left that all three could share.
SHARED_FUNCTION bool missesSquare(EdgeSweep edge0, EdgeSweep edge1, EdgeSweep edge2, vec2 centre, float reach) {
    vec2 r0 = edgeRange(edge0, centre, reach), r1 = edgeRange(edge1, centre, reach), r2 = edgeRange(edge2, centre, reach);
    return min(min(r0.y, r1.y), r2.y) < SHARED_FLOAT(0.0) && max(max(r0.x, r1.x), r2.x) > SHARED_FLOAT(0.0);
}

SHARED_END
