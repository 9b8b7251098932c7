#ifdef __cplusplus
#pragma once
#endif
#include "shared/quintic.shared.h"

// So many are looked at: nine changes take less, but for what rounding makes.
#define NONIC_PIECES 128

SHARED_BEGIN

/// A polynomial of degree 4 by its Bernstein coefficients over [0, 1]: b0 to b3 in `low`.
struct Quartic {
    vec4 low;
    float last;
};

SHARED_FUNCTION Quartic quarticSum(Quartic a, Quartic b) { return Quartic(a.low + b.low, a.last + b.last); }

/// Times what goes linearly from `first` to `last`; from 1 to 1, the same polynomial as one of degree 5. Flipping all
/// signs of p flips all signs.
SHARED_FUNCTION Quintic quinticOfQuartic(Quartic p, float first, float last) {
    const float fifth = SHARED_FLOAT(0.2), two = SHARED_FLOAT(2.0), three = SHARED_FLOAT(3.0), four = SHARED_FLOAT(4.0);
    SHARED_PRECISE float b1 = fifth * (four * p.low.y * first + p.low.x * last);
    SHARED_PRECISE float b2 = fifth * (three * p.low.z * first + two * p.low.y * last);
    SHARED_PRECISE float b3 = fifth * (two * p.low.w * first + three * p.low.z * last);
    SHARED_PRECISE float b4 = fifth * (p.last * first + four * p.low.w * last);
    return Quintic(vec3(p.low.x * first, b1, b2), vec3(b3, b4, p.last * last));
}

SHARED_FUNCTION Quintic quinticSum(Quintic a, Quintic b) { return Quintic(a.low + b.low, a.high + b.high); }

/// A polynomial of degree 9 by its Bernstein coefficients over [0, 1]: b0 to b3, b4 to b7, b8 and b9.
struct Nonic {
    vec4 low, middle;
    vec2 high;
};

/// The product. Error: some 2^-21 of the products of the coefficients' sizes.
SHARED_FUNCTION Nonic nonicProduct(Quintic p, Quartic q) {
    const float four = SHARED_FLOAT(4.0), five = SHARED_FLOAT(5.0), six = SHARED_FLOAT(6.0), ten = SHARED_FLOAT(10.0);
    float p0 = p.low.x, p1 = five * p.low.y, p2 = ten * p.low.z, p3 = ten * p.high.x, p4 = five * p.high.y,
          p5 = p.high.z;
    float q0 = q.low.x, q1 = four * q.low.y, q2 = six * q.low.z, q3 = four * q.low.w, q4 = q.last;
    SHARED_PRECISE float b0 = p0 * q0;
    SHARED_PRECISE float b1 = (p0 * q1 + p1 * q0) / SHARED_FLOAT(9.0);
    SHARED_PRECISE float b2 = (p0 * q2 + p1 * q1 + p2 * q0) / SHARED_FLOAT(36.0);
    SHARED_PRECISE float b3 = (p0 * q3 + p1 * q2 + p2 * q1 + p3 * q0) / SHARED_FLOAT(84.0);
    SHARED_PRECISE float b4 = (p0 * q4 + p1 * q3 + p2 * q2 + p3 * q1 + p4 * q0) / SHARED_FLOAT(126.0);
    SHARED_PRECISE float b5 = (p1 * q4 + p2 * q3 + p3 * q2 + p4 * q1 + p5 * q0) / SHARED_FLOAT(126.0);
    SHARED_PRECISE float b6 = (p2 * q4 + p3 * q3 + p4 * q2 + p5 * q1) / SHARED_FLOAT(84.0);
    SHARED_PRECISE float b7 = (p3 * q4 + p4 * q3 + p5 * q2) / SHARED_FLOAT(36.0);
    SHARED_PRECISE float b8 = (p4 * q4 + p5 * q3) / SHARED_FLOAT(9.0);
    return Nonic(vec4(b0, b1, b2, b3), vec4(b4, b5, b6, b7), vec2(b8, p5 * q4));
}

SHARED_FUNCTION Nonic nonicDifference(Nonic a, Nonic b) {
    return Nonic(a.low - b.low, a.middle - b.middle, a.high - b.high);
}

/// The part from `begin` to the end, again over [0, 1].
SHARED_FUNCTION Nonic nonicFrom(Nonic p, float begin) {
    const float zero = SHARED_FLOAT(0.0), one = SHARED_FLOAT(1.0);
    // In a step of de Casteljau's one coefficient less moves towards the next.
    for (int step = 1; step < 10; ++step) {
        float done = float(step);
        vec4 low = begin * clamp(vec4(10.0, 9.0, 8.0, 7.0) - vec4(done), zero, one);
        vec4 middle = begin * clamp(vec4(6.0, 5.0, 4.0, 3.0) - vec4(done), zero, one);
        float high = step == 1 ? begin : zero;
        p.low = mix(p.low, vec4(p.low.y, p.low.z, p.low.w, p.middle.x), low);
        p.middle = mix(p.middle, vec4(p.middle.y, p.middle.z, p.middle.w, p.high.x), middle);
        p.high.x = mix(p.high.x, p.high.y, high);
    }
    return p;
}

SHARED_FUNCTION Nonic nonicReversed(Nonic p) {
    return Nonic(vec4(p.high.y, p.high.x, p.middle.w, p.middle.z), vec4(p.middle.y, p.middle.x, p.low.w, p.low.z),
                 vec2(p.low.y, p.low.x));
}

/// The part from `begin` to `end`, again over [0, 1].
SHARED_FUNCTION Nonic nonicPart(Nonic p, float begin, float end) {
    Nonic until = nonicReversed(nonicFrom(nonicReversed(p), SHARED_FLOAT(1.0) - end));
    return nonicFrom(until, end > SHARED_FLOAT(0.0) ? begin / end : SHARED_FLOAT(0.0));
}

SHARED_FUNCTION float leastOf(Nonic p) {
    vec4 least = min(p.low, p.middle);
    return min(min(min(least.x, least.y), min(least.z, least.w)), min(p.high.x, p.high.y));
}

SHARED_FUNCTION float mostOf(Nonic p) {
    vec4 most = max(p.low, p.middle);
    return max(max(max(most.x, most.y), max(most.z, most.w)), max(p.high.x, p.high.y));
}

SHARED_FUNCTION float nonicCoefficient(Nonic p, int i) {
    if (i < 4) return i == 0 ? p.low.x : (i == 1 ? p.low.y : (i == 2 ? p.low.z : p.low.w));
    if (i < 8) return i == 4 ? p.middle.x : (i == 5 ? p.middle.y : (i == 6 ? p.middle.z : p.middle.w));
    return i == 8 ? p.high.x : p.high.y;
}

SHARED_FUNCTION CoefficientSigns signsOf(Nonic p, float doubt) {
    CoefficientSigns s = signOfFirst(p.low.x, doubt);
    for (int i = 1; i < 10; ++i) s = withSign(s, certainSign(nonicCoefficient(p, i), doubt));
    return s;
}

/// Where it changes its sign inside (0, 1), in no order; 2 in the places that are free.
struct NonicChanges {
    vec4 first, second;
    float last;
};

SHARED_FUNCTION NonicChanges noNonicChanges() {
    const float free = SHARED_FLOAT(2.0);
    return NonicChanges(vec4(free), vec4(free), free);
}

/// As quinticChange.
SHARED_FUNCTION float nonicChange(Nonic p, float low, float high, float signAtLow) {
    for (int i = 0; i < 25 && high - low > SHARED_FLOAT(5.9604645e-8); ++i) {
        float middle = SHARED_FLOAT(0.5) * (low + high);
        if (signAtLow * nonicFrom(p, middle).low.x > SHARED_FLOAT(0.0))
            low = middle;
        else
            high = middle;
    }
    return SHARED_FLOAT(0.5) * (low + high);
}

/// As quinticChanges.
SHARED_FUNCTION NonicChanges nonicChanges(Nonic p, float doubt) {
    const float zero = SHARED_FLOAT(0.0), one = SHARED_FLOAT(1.0);
    NonicChanges found = noNonicChanges();
    float width = one, before = zero;
    float begin = leastOf(p) < -doubt && mostOf(p) > doubt ? zero : one;
    for (int i = 0; begin < one && i < NONIC_PIECES; ++i) {
        CoefficientSigns signs = signsOf(nonicPart(p, begin, begin + width), doubt);
        float first = before != zero ? before : signs.first;
        PieceOfChanges piece = pieceOfChanges(signs, first, width);
        if (piece.isHalved) {
            width *= SHARED_FLOAT(0.5);
            continue;
        }
        if (piece.changes) {
            found.last = found.second.w;
            found.second = vec4(found.first.w, found.second.x, found.second.y, found.second.z);
            found.first =
                vec4(nonicChange(p, begin, begin + width, first), found.first.x, found.first.y, found.first.z);
        }
        if (signs.last != zero) before = signs.last;
        begin += width;
        width = widthFrom(begin, width);
    }
    return found;
}

SHARED_END
