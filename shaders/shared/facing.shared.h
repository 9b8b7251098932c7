#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

SHARED_BEGIN

/// Where a quadratic changes its sign inside (0, 1), ascending.
struct SignChanges {
    uint count;  // 0, 1 or 2
    float first, second;
};

/// Sign changes inside (0, 1) of the quadratic with the Bernstein coefficients b0, b1, b2: f(t) = b0 (1-t)^2 + 2 b1 t
/// (1-t)
/// + b2 t^2. Signs first: coefficients of one sign mean none. Then, in s = t / (1-t), where f is b0 + 2 b1 s + b2 s^2,
/// the root without cancellation q = -(b1 + sgn(b1) sqrt(b1^2 - b0 b2)), s = q / b2 or b0 / q, back as t = q / (q + b2)
/// or b0 / (b0 + q): sums of two numbers of one sign. Nothing blows up where the leading coefficient b0 - 2 b1 + b2
/// vanishes. A double root is no change of sign: none. Valid for coefficients that are 0 or of a size from 1e-18 to
/// 1e18 (their products have to exist). Error of a change, for coefficients taken as exact: at most 2^-21 where b0 and
/// b2 differ in sign; for two changes 2^-21 (1 + b1^2 / D), D = b1^2 - b0 b2: as near as floats can tell two roots that
/// nearly meet. Source: Kahan 2004, "On the cost of floating-point computation without extra-precise arithmetic"; the
/// projective form is derived here.
SHARED_FUNCTION SignChanges signChangesOfQuadratic(float b0, float b1, float b2) {
    SignChanges none = SignChanges(0u, SHARED_FLOAT(0.0), SHARED_FLOAT(0.0));
    bool opposite =
        (b0 > SHARED_FLOAT(0.0) && b2 < SHARED_FLOAT(0.0)) || (b0 < SHARED_FLOAT(0.0) && b2 > SHARED_FLOAT(0.0));
    // Two changes need the middle coefficient on the other side of both ends.
    bool dips = (b0 > SHARED_FLOAT(0.0) && b1 < SHARED_FLOAT(0.0) && b2 > SHARED_FLOAT(0.0)) ||
                (b0 < SHARED_FLOAT(0.0) && b1 > SHARED_FLOAT(0.0) && b2 < SHARED_FLOAT(0.0));
    if (opposite || dips) {
        SHARED_PRECISE float discriminant = b1 * b1 - b0 * b2;
        if (dips && !(discriminant > SHARED_FLOAT(0.0))) return none;
        SHARED_PRECISE float q = -(b1 + (b1 < SHARED_FLOAT(0.0) ? -sqrt(discriminant) : sqrt(discriminant)));
        // Of opposite ends, one root is in (0, 1): the one whose s is positive.
        bool farRoot = (q > SHARED_FLOAT(0.0)) == (b2 > SHARED_FLOAT(0.0));
        if (opposite) {  // the other may lie at infinity, where it would be a division by 0
            SHARED_PRECISE float t = farRoot ? q / (q + b2) : b0 / (b0 + q);
            return SignChanges(1u, t, SHARED_FLOAT(0.0));
        }
        SHARED_PRECISE float t1 = q / (q + b2);
        SHARED_PRECISE float t2 = b0 / (b0 + q);
        return SignChanges(2u, min(t1, t2), max(t1, t2));
    }
    // An end that is 0 leaves a linear factor: t (2 b1 (1-t) + b2 t), or its mirror image.
    if (b0 == SHARED_FLOAT(0.0) &&
        ((b1 > SHARED_FLOAT(0.0) && b2 < SHARED_FLOAT(0.0)) || (b1 < SHARED_FLOAT(0.0) && b2 > SHARED_FLOAT(0.0)))) {
        float twice = SHARED_FLOAT(2.0) * b1;
        return SignChanges(1u, twice / (twice - b2), SHARED_FLOAT(0.0));
    }
    if (b2 == SHARED_FLOAT(0.0) &&
        ((b1 > SHARED_FLOAT(0.0) && b0 < SHARED_FLOAT(0.0)) || (b1 < SHARED_FLOAT(0.0) && b0 > SHARED_FLOAT(0.0)))) {
        float twice = SHARED_FLOAT(2.0) * b1;
        return SignChanges(1u, b0 / (b0 - twice), SHARED_FLOAT(0.0));
    }
    return none;
}

/// When a quadratic is positive: none, one or two intervals of [0, 1], as (begin, end) in xy and zw; an empty one is
/// (0, 0). Same validity and error as its changes of sign.
SHARED_FUNCTION vec4 positiveIntervals(float b0, float b1, float b2) {
    SignChanges c = signChangesOfQuadratic(b0, b1, b2);
    // The sign before the first change: that of the first coefficient that is not 0.
    float opening = b0 != SHARED_FLOAT(0.0) ? b0 : (b1 != SHARED_FLOAT(0.0) ? b1 : b2);
    bool positive = opening > SHARED_FLOAT(0.0);
    if (c.count == 0u)
        return vec4(SHARED_FLOAT(0.0), positive ? SHARED_FLOAT(1.0) : SHARED_FLOAT(0.0), SHARED_FLOAT(0.0),
                    SHARED_FLOAT(0.0));
    if (c.count == 1u)
        return positive ? vec4(SHARED_FLOAT(0.0), c.first, SHARED_FLOAT(0.0), SHARED_FLOAT(0.0))
                        : vec4(c.first, SHARED_FLOAT(1.0), SHARED_FLOAT(0.0), SHARED_FLOAT(0.0));
    return positive ? vec4(SHARED_FLOAT(0.0), c.first, c.second, SHARED_FLOAT(1.0))
                    : vec4(c.first, c.second, SHARED_FLOAT(0.0), SHARED_FLOAT(0.0));
}

/// Bernstein coefficients of normal(t) . towardsLight(t) for both linear in t: the receiver faces the light where they
/// are positive (equation 2.5 of Palmér, "Analytical motion blurred shadows"). The normal is never normalised:
/// a face that turns by half a turn has none half-way.
SHARED_FUNCTION vec3 facingCoefficients(vec3 normalOpen, vec3 normalClose, vec3 lightOpen, vec3 lightClose) {
    return vec3(dot(normalOpen, lightOpen),
                SHARED_FLOAT(0.5) * (dot(normalClose, lightOpen) + dot(normalOpen, lightClose)),
                dot(normalClose, lightClose));
}

SHARED_END
