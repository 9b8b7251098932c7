#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

SHARED_BEGIN

/// How near the plane of a caster may pass a receiver and still not shadow it, in world units: a bound on the rounding
/// of the receiver's own position, and no share of the way to the light, so that far lights and large grounds lose no
/// shadows (docs/numerics.md, "Definition of shadow"). 2^-21 of the largest coordinate of the receiver's triangle,
/// whose vertices at its time are given: a point that is their weighted sum in floats lies within 5 * 2^-24 of that of
/// where it should, and a caster's vertex that was rounded once within 2^-24.
SHARED_FUNCTION float receiverClearance(vec3 v0, vec3 v1, vec3 v2) {
    vec3 a = abs(v0), b = abs(v1), c = abs(v2);
    float largest = max(max(max(a.x, a.y), max(a.z, b.x)), max(max(b.y, b.z), max(c.x, max(c.y, c.z))));
    return largest * SHARED_FLOAT(4.76837158203125e-7);
}

/// A vertex at time u seen from the receiver, for a vertex that moves linearly from `open` to `close`. The receiver is
/// subtracted before anything is multiplied: near a contact the difference is exact, and a static vertex is
/// exactly where it is at every u, which mix(open, close, u) does not give.
/// Error: at most 2^-23 (|open - receiver| + |close - open|) per coordinate.
SHARED_FUNCTION vec3 vertexFromReceiver(vec3 open, vec3 close, float u, vec3 receiver) {
    SHARED_PRECISE vec3 v = (open - receiver) + (close - open) * u;
    return v;
}

/// Twice det[direction, a, b]: on which side of the edge from a to b a ray from the origin passes. Swapping a and b
/// flips the sign exactly, so triangles that share an edge leave no gap between them. (b + a) x (b - a) is twice a x b,
/// but keeps its precision for short edges far away, where the products of a x b cancel (Pluecker coordinates as
/// Embree's robust triangle test takes them; Davidovic, Engelhardt, Georgiev, Slusallek, Dachsbacher 2012, "3D
/// rasterization"). Error: at most 9 * 2^-24 times the sum of the sizes of the six products of the components of b + a,
/// b - a, direction.
SHARED_FUNCTION float edgeSide(vec3 direction, vec3 a, vec3 b) {
    SHARED_PRECISE vec3 sum = b + a;
    SHARED_PRECISE vec3 difference = b - a;
    SHARED_PRECISE vec3 normal =
        vec3(sum.y * difference.z - sum.z * difference.y, sum.z * difference.x - sum.x * difference.z,
             sum.x * difference.y - sum.y * difference.x);
    SHARED_PRECISE float side = normal.x * direction.x + normal.y * direction.y + normal.z * direction.z;
    return side;
}

/// Does the segment from the receiver (the origin) to the light (`toLight`) meet the triangle, whose vertices are given
/// relative to the receiver, short of its ends? Triangles are closed (edges count) and have no back;
/// one in a common plane with the segment, or without area, is not met. A hit lies on one side of all three edges; its
/// distance is W / V, W = v0 . n, V = toLight . n with the normal n of two edges, compared without a division.
///
/// `clearance` >= 0, in world units: a receiver that is not farther than this from the triangle's plane is taken to
/// lie in it and is not shadowed by it (receiverClearance). The triangle that the receiver lies on is the caller's to
/// leave out, by its number; its neighbours in the same plane need this rule, because a rounded receiver lies as often
/// beyond the common edge as not.
///
/// Valid while all lengths lie between 1e-9 and 1e9, whatever their ratio: no product overflows or is lost. Any NaN or
/// infinity among the inputs: no hit. Decides as exact arithmetic would unless an edge side is within its bound above
/// of 0, or W within 2^-20 times the sum of the sizes of its products, and of those of V, of clearance |n| or of V.
SHARED_FUNCTION bool segmentMeetsTriangle(vec3 toLight, vec3 v0, vec3 v1, vec3 v2, float clearance) {
    float e0 = edgeSide(toLight, v1, v2);
    float e1 = edgeSide(toLight, v2, v0);
    float e2 = edgeSide(toLight, v0, v1);
    float least = min(e0, min(e1, e2)), most = max(e0, max(e1, e2));
    if (!(least >= SHARED_FLOAT(0.0) || most <= SHARED_FLOAT(0.0))) return false;
    SHARED_PRECISE vec3 a = v1 - v0;
    SHARED_PRECISE vec3 b = v2 - v0;
    SHARED_PRECISE vec3 n = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    SHARED_PRECISE float plane = n.x * v0.x + n.y * v0.y + n.z * v0.z;
    SHARED_PRECISE float through = n.x * toLight.x + n.y * toLight.y + n.z * toLight.z;
    if (through < SHARED_FLOAT(0.0)) {
        plane = -plane;
        through = -through;
    }
    bool within = plane > SHARED_FLOAT(0.0) && plane < through && through < SHARED_FLOAT(3e38);
    bool anyEdge = most > SHARED_FLOAT(0.0) || least < SHARED_FLOAT(0.0);
    return within && anyEdge && plane > clearance * length(n);
}

SHARED_END
