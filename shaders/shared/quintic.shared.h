#ifdef __cplusplus
#pragma once
#endif
#include "shared/cubic.shared.h"

// So many are looked at: five changes take less. Only rounding makes more, where next to nothing is left of a
// difference.
#define QUINTIC_PIECES 64

SHARED_BEGIN

/// A polynomial of degree 5 by its Bernstein coefficients over [0, 1]: b0, b1, b2 in `low`, b3, b4, b5 in `high`.
struct Quintic {
    vec3 low, high;
};

/// Of a cubic times a quadratic, by their Bernstein coefficients. Error: some 2^-22 of the products' sizes.
SHARED_FUNCTION Quintic quinticProduct(vec4 p, vec3 q) {
    const float tenth = SHARED_FLOAT(0.1), fifth = SHARED_FLOAT(0.2);
    SHARED_PRECISE float b0 = p.x * q.x;
    SHARED_PRECISE float b1 = fifth * (SHARED_FLOAT(2.0) * p.x * q.y + SHARED_FLOAT(3.0) * p.y * q.x);
    SHARED_PRECISE float b2 = tenth * (p.x * q.z + SHARED_FLOAT(6.0) * p.y * q.y + SHARED_FLOAT(3.0) * p.z * q.x);
    SHARED_PRECISE float b3 = tenth * (SHARED_FLOAT(3.0) * p.y * q.z + SHARED_FLOAT(6.0) * p.z * q.y + p.w * q.x);
    SHARED_PRECISE float b4 = fifth * (SHARED_FLOAT(3.0) * p.z * q.z + SHARED_FLOAT(2.0) * p.w * q.y);
    SHARED_PRECISE float b5 = p.w * q.z;
    return Quintic(vec3(b0, b1, b2), vec3(b3, b4, b5));
}

SHARED_FUNCTION Quintic quinticDifference(Quintic a, Quintic b) { return Quintic(a.low - b.low, a.high - b.high); }

/// The part from `low` to the end, again over [0, 1].
SHARED_FUNCTION Quintic quinticFrom(Quintic p, float low) {
    vec3 a = mix(p.low, vec3(p.low.y, p.low.z, p.high.x), low);
    float a3 = mix(p.high.x, p.high.y, low), a4 = mix(p.high.y, p.high.z, low);
    vec3 b = mix(a, vec3(a.y, a.z, a3), low);
    float b3 = mix(a3, a4, low);
    vec3 c = mix(b, vec3(b.y, b.z, b3), low);
    vec2 d = mix(vec2(c.x, c.y), vec2(c.y, c.z), low);
    return Quintic(vec3(mix(d.x, d.y, low), d.y, c.z), vec3(b3, a4, p.high.z));
}

/// Value at t, by de Casteljau's steps: where the part from t on begins.
SHARED_FUNCTION float quinticAt(Quintic p, float t) { return quinticFrom(p, t).low.x; }

SHARED_FUNCTION Quintic quinticReversed(Quintic p) {
    return Quintic(vec3(p.high.z, p.high.y, p.high.x), vec3(p.low.z, p.low.y, p.low.x));
}

/// The part from `low` to `high`, again over [0, 1].
SHARED_FUNCTION Quintic quinticPart(Quintic p, float low, float high) {
    Quintic until = quinticReversed(quinticFrom(quinticReversed(p), SHARED_FLOAT(1.0) - high));
    return quinticFrom(until, high > SHARED_FLOAT(0.0) ? low / high : SHARED_FLOAT(0.0));
}

SHARED_FUNCTION float leastOf(Quintic p) {
    vec3 least = min(p.low, p.high);
    return min(min(least.x, least.y), least.z);
}

SHARED_FUNCTION float mostOf(Quintic p) {
    vec3 most = max(p.low, p.high);
    return max(max(most.x, most.y), most.z);
}

/// 1 or -1, and 0 of what is no more than `doubt`.
SHARED_FUNCTION float certainSign(float b, float doubt) {
    return b > doubt ? SHARED_FLOAT(1.0) : (b < -doubt ? SHARED_FLOAT(-1.0) : SHARED_FLOAT(0.0));
}

/// The signs of coefficients in order: how often they change, those left out that are 0 but for a doubt, and the first
/// and the last of the others; 0 where there are none.
struct CoefficientSigns {
    uint variations;
    float first, last;
};

SHARED_FUNCTION CoefficientSigns signOfFirst(float b, float doubt) {
    float side = certainSign(b, doubt);
    return CoefficientSigns(0u, side, side);
}

SHARED_FUNCTION CoefficientSigns withSign(CoefficientSigns s, float side) {
    const float zero = SHARED_FLOAT(0.0);
    if (side * s.last < zero) s.variations += 1u;
    if (s.first == zero) s.first = side;
    if (side != zero) s.last = side;
    return s;
}

SHARED_FUNCTION CoefficientSigns signsOf(Quintic p, float doubt) {
    CoefficientSigns s = signOfFirst(p.low.x, doubt);
    s = withSign(withSign(s, certainSign(p.low.y, doubt)), certainSign(p.low.z, doubt));
    s = withSign(withSign(s, certainSign(p.high.x, doubt)), certainSign(p.high.y, doubt));
    return withSign(s, certainSign(p.high.z, doubt));
}

/// What becomes of a dyadic piece of [0, 1] in which a polynomial's changes of sign are sought.
struct PieceOfChanges {
    bool isHalved;  // else it has one change, or none
    bool changes;
};

/// `first`: the sign before the piece, which may be known better from the one to its left.
SHARED_FUNCTION PieceOfChanges pieceOfChanges(CoefficientSigns signs, float first, float width) {
    bool changes = first * signs.last < SHARED_FLOAT(0.0);
    uint variations = signs.variations + (first * signs.first < SHARED_FLOAT(0.0) ? 1u : 0u);
    float least = changes ? SHARED_FLOAT(5.9604645e-8) : SHARED_FLOAT(9.5367432e-7);
    bool isSingle = changes && variations <= 1u;
    return PieceOfChanges(!isSingle && (changes || variations > 1u) && width > least, changes);
}

/// Of the largest dyadic piece that begins there and is no smaller.
SHARED_FUNCTION float widthFrom(float begin, float width) {
    while (width < SHARED_FLOAT(1.0) && fract(begin / (SHARED_FLOAT(2.0) * width)) == SHARED_FLOAT(0.0))
        width *= SHARED_FLOAT(2.0);
    return width;
}

/// Where it changes its sign inside (0, 1), at most five times; 2 in the places that are free.
struct QuinticChanges {
    vec3 first;
    vec2 second;
};

/// The change of sign between `low` and `high`, of which there is one: by halving, to 2^-24, by the value's own sign.
SHARED_FUNCTION float quinticChange(Quintic p, float low, float high, float signAtLow) {
    for (int i = 0; i < 25 && high - low > SHARED_FLOAT(5.9604645e-8); ++i) {
        float middle = SHARED_FLOAT(0.5) * (low + high);
        if (signAtLow * quinticAt(p, middle) > SHARED_FLOAT(0.0))
            low = middle;
        else
            high = middle;
    }
    return SHARED_FLOAT(0.5) * (low + high);
}

/// Dyadic pieces are looked at from left to right, and halved while their coefficients change their sign more than once
/// (Descartes' rule, in Bernstein form: Collins and Akritas 1976); in a piece with one change it is found by
/// halving, to 2^-24. A piece of 2^-20 whose coefficients still change their sign more than once is taken for one
/// change where its ends differ, and for none where they do not: two changes nearer than that are missed as a pair.
/// `doubt`: coefficients that are no larger have no sign; what is all in doubt does not change. Swapping all signs
/// gives the same times.
SHARED_FUNCTION QuinticChanges quinticChanges(Quintic p, float doubt) {
    const float zero = SHARED_FLOAT(0.0), one = SHARED_FLOAT(1.0), two = SHARED_FLOAT(2.0);
    QuinticChanges found = QuinticChanges(vec3(two), vec2(two));
    uint count = 0u;
    float width = one, before = zero;
    float begin = leastOf(p) < -doubt && mostOf(p) > doubt ? zero : one;
    for (int i = 0; begin < one && i < QUINTIC_PIECES; ++i) {
        CoefficientSigns signs = signsOf(quinticPart(p, begin, begin + width), doubt);
        float first = before != zero ? before : signs.first;  // ends that two pieces share round to two values
        PieceOfChanges piece = pieceOfChanges(signs, first, width);
        if (piece.isHalved) {
            width *= SHARED_FLOAT(0.5);
            continue;
        }
        if (piece.changes) {
            float at = quinticChange(p, begin, begin + width, first);
            if (count == 0u) found.first.x = at;
            if (count == 1u) found.first.y = at;
            if (count == 2u) found.first.z = at;
            if (count == 3u) found.second.x = at;
            if (count == 4u) found.second.y = at;
            count += 1u;
        }
        if (signs.last != zero) before = signs.last;
        begin += width;
        width = widthFrom(begin, width);
    }
    return found;
}

SHARED_END
