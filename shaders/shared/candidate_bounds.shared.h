#ifdef __cplusplus
#pragma once
#endif
#include "shared/swept_bounds.shared.h"

SHARED_BEGIN

/// Bound on the error of a position in the shadow map, in map widths: receivers and casters are transformed by the
/// same matrices, each with an error of a few units of 2^-24 of the scene's extent over the distance.
#define MAP_POSITION_SLACK SHARED_FLOAT(1e-5)

/// Set in a candidate's triangle number when the triangle moves in the world: its second position must be read.
#define CANDIDATE_MOVES 0x80000000u

/// Entries of which one texel holds all bounds and the next one all triangle numbers: fetches are what reading a list
/// costs.
#define CANDIDATES_TOGETHER 4u

/// The word with an entry's bounds, among all words; its triangle number lies CANDIDATES_TOGETHER further on.
SHARED_FUNCTION uint candidatePlace(uint entry) {
    return entry / CANDIDATES_TOGETHER * (2u * CANDIDATES_TOGETHER) + entry % CANDIDATES_TOGETHER;
}

/// Bits above the fields of a candidate's bounds: never set in them, always set in a receiver's place.
#define CANDIDATE_GUARDS 0x80084210u

/// A depth in 11 bits that never decrease: 128 steps an octave, from `least` upwards over 16 octaves; what is nearer is
/// 0, what is farther 2047.
SHARED_FUNCTION uint depthStep(float depth, float least) {
    int step = int(floatBitsToUint(max(depth, SHARED_FLOAT(0.0))) >> 16u) - int(floatBitsToUint(least) >> 16u);
    return uint(clamp(step, 0, 2047));
}

/// Where in its cell, and how near at the least, a candidate is, in one word of fields with a guard bit above each: the
/// low corner of its bounds and what lies beyond the high one in sixteenths of the cell (4 bits each), and depthStep.
/// Bounds in cells, relative to the cell's low corner.
SHARED_FUNCTION uint packCandidateBounds(vec2 low, vec2 high, uint nearestStep) {
    uvec2 first = uvec2(clamp(floor(low * SHARED_FLOAT(16.0)), vec2(0), vec2(15)));
    uvec2 beyond = uvec2(15u) - uvec2(clamp(floor(high * SHARED_FLOAT(16.0)), vec2(0), vec2(15)));
    return first.x | (first.y << 5u) | (beyond.x << 10u) | (beyond.y << 15u) | (nearestStep << 20u);
}

/// A receiver in the same fields, that moves within its cell, in the box from `low` to `high`, and is nowhere farther
/// than its step.
SHARED_FUNCTION uint packReceiverBox(vec2 low, vec2 high, uint receiverStep) {
    uvec2 place = uvec2(clamp(floor(high * SHARED_FLOAT(16.0)), vec2(0), vec2(15)));
    uvec2 left = uvec2(15u) - uvec2(clamp(floor(low * SHARED_FLOAT(16.0)), vec2(0), vec2(15)));
    return place.x | (place.y << 5u) | (left.x << 10u) | (left.y << 15u) | (receiverStep << 20u) | CANDIDATE_GUARDS;
}

/// A receiver at one place. `inCell`: in cells, relative to the cell's low corner.
SHARED_FUNCTION uint packReceiverPlace(vec2 inCell, uint receiverStep) {
    return packReceiverBox(inCell, inCell, receiverStep);
}

/// Can the candidate shadow the receiver? False only where it can't. All fields are compared by one difference: a guard
/// that had to be borrowed from is a field of the receiver that is less than the candidate's.
SHARED_FUNCTION bool candidateReaches(uint bounds, uint receiver) {
    return ((receiver - bounds) & CANDIDATE_GUARDS) == CANDIDATE_GUARDS;
}

/// A moving triangle's three edges as the light sees them during an interval. Seen through the map position p, edge k
/// has the function e_k(u, p) = (V_i(u) x V_j(u)) . (p, 1) with V = (X, Y, Z), or (X, Y, 1) when orthographic: a
/// quadratic in u whose Bernstein coefficients are linear in p. p is inside at u iff the three e_k have one sign.
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
/// `centre`, at any time of the interval: a quadratic lies between its Bernstein coefficients. Widened by its own
/// rounding.
SHARED_FUNCTION vec2 edgeRange(EdgeSweep sweep, vec2 centre, float reach) {
    vec3 point = vec3(centre, 1);
    vec3 magnitude = vec3(abs(centre) + vec2(reach), 1);
    float first = dot(sweep.first, point), middle = dot(sweep.middle, point), last = dot(sweep.last, point);
    vec3 slack = SHARED_FLOAT(1e-6) * magnitude + vec3(reach, reach, 0);
    float firstReach = dot(abs(sweep.first), slack), middleReach = dot(abs(sweep.middle), slack),
          lastReach = dot(abs(sweep.last), slack);
    return vec2(min(min(first - firstReach, middle - middleReach), last - lastReach),
                max(max(first + firstReach, middle + middleReach), last + lastReach));
}

/// Can the triangle cover no point of the square throughout the interval? False where in doubt. If one edge function is
/// negative all over it and another positive, no sign is left that all three could share.
SHARED_FUNCTION bool missesSquare(EdgeSweep edge0, EdgeSweep edge1, EdgeSweep edge2, vec2 centre, float reach) {
    vec2 r0 = edgeRange(edge0, centre, reach), r1 = edgeRange(edge1, centre, reach),
         r2 = edgeRange(edge2, centre, reach);
    return min(min(r0.y, r1.y), r2.y) < SHARED_FLOAT(0.0) && max(max(r0.x, r1.x), r2.x) > SHARED_FLOAT(0.0);
}

SHARED_END
