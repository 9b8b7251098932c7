#ifdef __cplusplus
#pragma once
#endif
#include "shared/quintic.shared.h"

#define BERNSTEIN_ROOM 10  // coefficients: degree 9 at most

SHARED_BEGIN

/// A polynomial over [0, 1] by its Bernstein coefficients b[0] .. b[degree]. Between the least and the greatest of them
/// lies the polynomial, and it changes its sign at most as often as they do.
struct Bernstein {
    uint degree;
    float b[BERNSTEIN_ROOM];
};

/// Where a polynomial changes its sign inside (0, 1), ascending.
struct BernsteinChanges {
    uint count;
    float at[BERNSTEIN_ROOM];
};

SHARED_FUNCTION Bernstein bernsteinConstant(float value) {
    Bernstein p;
    p.degree = 0u;
    for (int i = 0; i < BERNSTEIN_ROOM; ++i) p.b[i] = i == 0 ? value : SHARED_FLOAT(0.0);
    return p;
}

SHARED_FUNCTION Bernstein bernsteinLinear(float first, float last) {
    Bernstein p = bernsteinConstant(first);
    p.degree = 1u;
    p.b[1] = last;
    return p;
}

/// n over k, exact for n < 10.
SHARED_FUNCTION float binomial(uint n, uint k) {
    float value = SHARED_FLOAT(1.0);
    for (uint i = 1u; i <= k; ++i) value = value * float(n + 1u - i) / float(i);
    return value;
}

/// The product; the degrees' sum is at most 9. Error: some 2^-22 of the products of the coefficients' sizes.
SHARED_FUNCTION Bernstein bernsteinProduct(Bernstein p, Bernstein q) {
    Bernstein r = bernsteinConstant(SHARED_FLOAT(0.0));
    r.degree = p.degree + q.degree;
    for (uint i = 0u; i <= p.degree; ++i)
        for (uint j = 0u; j <= q.degree; ++j)
            r.b[i + j] += binomial(p.degree, i) * binomial(q.degree, j) / binomial(r.degree, i + j) * p.b[i] * q.b[j];
    return r;
}

/// The sum of two of one degree.
SHARED_FUNCTION Bernstein bernsteinSum(Bernstein p, Bernstein q, float scale) {
    for (uint i = 0u; i <= p.degree; ++i) p.b[i] += scale * q.b[i];
    return p;
}

/// The part from `low` to `high`, again over [0, 1].
SHARED_FUNCTION Bernstein bernsteinPart(Bernstein p, float low, float high) {
    uint d = p.degree;
    // What lies beyond `high` is cut away first, then what lies before `low`.
    for (uint n = 1u; n <= d; ++n)
        for (uint i = d; i >= n; --i) p.b[i] = p.b[i - 1u] + (p.b[i] - p.b[i - 1u]) * high;
    float t = high > SHARED_FLOAT(0.0) ? low / high : SHARED_FLOAT(0.0);
    for (uint n = 1u; n <= d; ++n)
        for (uint i = 0u; i <= d - n; ++i) p.b[i] += (p.b[i + 1u] - p.b[i]) * t;
    return p;
}

SHARED_FUNCTION float bernsteinLeast(Bernstein p) {
    float least = p.b[0];
    for (uint i = 1u; i <= p.degree; ++i) least = min(least, p.b[i]);
    return least;
}

SHARED_FUNCTION float bernsteinMost(Bernstein p) {
    float most = p.b[0];
    for (uint i = 1u; i <= p.degree; ++i) most = max(most, p.b[i]);
    return most;
}

SHARED_FUNCTION float bernsteinSize(Bernstein p) { return max(bernsteinMost(p), -bernsteinLeast(p)); }

/// The signs of its coefficients, as QuinticSigns has them.
SHARED_FUNCTION QuinticSigns signsOf(Bernstein p, float doubt) {
    const float zero = SHARED_FLOAT(0.0);
    float opening = certainSign(p.b[0], doubt);
    QuinticSigns s = QuinticSigns(0u, opening, opening, opening == zero);
    for (uint i = 1u; i <= p.degree; ++i) {
        float side = certainSign(p.b[i], doubt);
        if (side * s.last < zero) s.variations += 1u;
        if (s.first == zero) s.first = side;
        if (side != zero) s.last = side;
    }
    return s;
}

/// Where it changes its sign inside (0, 1): as quinticChanges, for any degree.
SHARED_FUNCTION BernsteinChanges bernsteinChanges(Bernstein p, float doubt) {
    const float zero = SHARED_FLOAT(0.0), one = SHARED_FLOAT(1.0), two = SHARED_FLOAT(2.0);
    BernsteinChanges found;
    found.count = 0u;
    for (int i = 0; i < BERNSTEIN_ROOM; ++i) found.at[i] = two;
    float width = one, before = zero;
    float begin = bernsteinLeast(p) < -doubt && bernsteinMost(p) > doubt ? zero : one;
    for (int i = 0; begin < one && i < 2 * QUINTIC_PIECES; ++i) {
        QuinticSigns signs = signsOf(bernsteinPart(p, begin, begin + width), doubt);
        float first = before != zero ? before : signs.first;  // ends that two pieces share round to two values
        bool changes = first * signs.last < zero;
        float least = changes ? SHARED_FLOAT(5.9604645e-8) : SHARED_FLOAT(9.5367432e-7);
        if ((changes || signs.variations > 1u) && width > least) {
            width *= SHARED_FLOAT(0.5);
            continue;
        }
        if (changes && found.count < p.degree) {
            found.at[found.count] = begin + SHARED_FLOAT(0.5) * width;
            found.count += 1u;
        }
        if (signs.last != zero) before = signs.last;
        begin += width;
        while (width < one && fract(begin / (two * width)) == zero) width *= two;
    }
    return found;
}

SHARED_END
