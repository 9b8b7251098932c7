#ifdef __cplusplus
#pragma once
#endif
#include "shared/facing.shared.h"

SHARED_BEGIN

/// Value at t of the cubic with the Bernstein coefficients b over [0, 1], by de Casteljau's steps: convex combinations,
/// which lose nothing to cancellation. Error: at most 2^-20 max |b|.
SHARED_FUNCTION float cubicAt(vec4 b, float t) {
    SHARED_PRECISE float p0 = b.x + (b.y - b.x) * t;
    SHARED_PRECISE float p1 = b.y + (b.z - b.y) * t;
    SHARED_PRECISE float p2 = b.z + (b.w - b.z) * t;
    SHARED_PRECISE float q0 = p0 + (p1 - p0) * t;
    SHARED_PRECISE float q1 = p1 + (p2 - p1) * t;
    SHARED_PRECISE float value = q0 + (q1 - q0) * t;
    return value;
}

/// A third of its derivative.
SHARED_FUNCTION float cubicSlopeAt(vec4 b, float t) {
    SHARED_PRECISE float d0 = b.y - b.x;
    SHARED_PRECISE float d1 = b.z - b.y;
    SHARED_PRECISE float d2 = b.w - b.z;
    SHARED_PRECISE float e0 = d0 + (d1 - d0) * t;
    SHARED_PRECISE float e1 = d1 + (d2 - d1) * t;
    SHARED_PRECISE float slope = e0 + (e1 - e0) * t;
    return slope;
}

/// The root between `low` and `high`, at which the cubic has different signs and between which it is monotonic:
/// Newton's steps kept inside a bracket that halves where they leave it. Ends where a step moves by less than 2^-24.
SHARED_FUNCTION float refinedRoot(vec4 b, float low, float high, bool positiveAtLow) {
    float t = SHARED_FLOAT(0.5) * (low + high);
    for (int i = 0; i < 40; ++i) {
        float value = cubicAt(b, t);
        if (value == SHARED_FLOAT(0.0)) return t;
        if ((value > SHARED_FLOAT(0.0)) == positiveAtLow)
            low = t;
        else
            high = t;
        float slope = SHARED_FLOAT(3.0) * cubicSlopeAt(b, t);
        float next = slope != SHARED_FLOAT(0.0) ? t - value / slope : low;
        // Newton's steps may creep towards a flat root from one side: every fourth is a halving.
        if (!(next > low && next < high) || (i & 3) == 3) next = SHARED_FLOAT(0.5) * (low + high);
        float step = abs(next - t);
        t = next;
        if (step < SHARED_FLOAT(5.9604645e-8)) break;
    }
    return t;
}

/// Sign changes inside (0, 1) of a cubic, ascending in xyz.
struct CubicSignChanges {
    uint count;  // 0 to 3
    vec3 at;
};

/// Where the cubic with the Bernstein coefficients b changes its sign inside (0, 1). Signs first: coefficients of one
/// sign mean none. Otherwise the unit interval is cut where the derivative changes its sign; each piece whose ends
/// differ in sign holds one root, which is refined. (Isolation at critical points: Yuksel 2022, "High-performance
/// polynomial root finding for graphics"; the derivative's roots: signChangesOfQuadratic.) Guarantee: taken piece by
/// piece, the sign that follows from the changes is the cubic's wherever |f| > 2^-18 max |b|. So a pair of roots
/// between which f stays below that may be missed, and is missed or found as one. Valid for max |b| from 1e-15 to 1e15.
SHARED_FUNCTION CubicSignChanges signChangesOfCubic(vec4 b) {
    CubicSignChanges found = CubicSignChanges(0u, vec3(SHARED_FLOAT(0.0)));
    float least = min(min(b.x, b.y), min(b.z, b.w)), most = max(max(b.x, b.y), max(b.z, b.w));
    if (!(least < SHARED_FLOAT(0.0) && most > SHARED_FLOAT(0.0))) return found;
    SignChanges turns = signChangesOfQuadratic(b.y - b.x, b.z - b.y, b.w - b.z);
    float begin = SHARED_FLOAT(0.0);
    float atBegin = b.x;
    for (uint piece = 0u; piece <= turns.count; ++piece) {
        float end = piece == turns.count ? SHARED_FLOAT(1.0) : (piece == 0u ? turns.first : turns.second);
        float atEnd = piece == turns.count ? b.w : cubicAt(b, end);
        if ((atBegin > SHARED_FLOAT(0.0) && atEnd < SHARED_FLOAT(0.0)) ||
            (atBegin < SHARED_FLOAT(0.0) && atEnd > SHARED_FLOAT(0.0))) {
            float root = refinedRoot(b, begin, end, atBegin > SHARED_FLOAT(0.0));
            if (found.count == 0u)
                found.at.x = root;
            else if (found.count == 1u)
                found.at.y = root;
            else
                found.at.z = root;
            found.count += 1u;
        }
        // A value of exactly 0 does not give the sign before or after it: the piece is joined to the next.
        if (atEnd != SHARED_FLOAT(0.0)) {
            begin = end;
            atBegin = atEnd;
        }
    }
    return found;
}

/// The sign that follows from the changes, at t: 1 or -1.
SHARED_FUNCTION float signFromChanges(vec4 b, CubicSignChanges changes, float t) {
    float opening =
        b.x != SHARED_FLOAT(0.0) ? b.x : (b.y != SHARED_FLOAT(0.0) ? b.y : (b.z != SHARED_FLOAT(0.0) ? b.z : b.w));
    float side = opening < SHARED_FLOAT(0.0) ? SHARED_FLOAT(-1.0) : SHARED_FLOAT(1.0);
    if (changes.count > 0u && t > changes.at.x) side = -side;
    if (changes.count > 1u && t > changes.at.y) side = -side;
    if (changes.count > 2u && t > changes.at.z) side = -side;
    return side;
}

SHARED_END
