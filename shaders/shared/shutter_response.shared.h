#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// How much the light of each instant counts (w(t) of Palmer's equation 2.1).
#define SHUTTER_BOX 0u       // all instants alike
#define SHUTTER_TENT 1u      // rises from 0 where the shutter opens, falls to 0 where it closes
#define SHUTTER_GAUSSIAN 2u  // about the middle of the shutter, cut at its ends

SHARED_BEGIN

/// The shutter's response w at the time u in [0, 1], as a share of that in the middle: of 1 at u = 1/2. `width` is the
/// standard deviation of the Gaussian in u, 0.05 .. 2; of the others it is not read. At least 1e-15, so that no sum of
/// weights is 0. Relative error of the Gaussian: that of its exponent and of exp, at most 2^-15.
SHARED_FUNCTION float shutterWeight(uint response, float width, float u) {
    if (response == SHUTTER_BOX) return SHARED_FLOAT(1.0);
    float off = abs(u - SHARED_FLOAT(0.5));
    float weight = SHARED_FLOAT(1.0) - SHARED_FLOAT(2.0) * off;
    if (response == SHUTTER_GAUSSIAN) {
        float deviations = off / width;
        weight = exp(SHARED_FLOAT(-0.5) * deviations * deviations);
    }
    return max(weight, SHARED_FLOAT(1e-15));
}

/// The error function for x >= 0, within 7e-7: 1.5e-7 of Abramowitz and Stegun 1964, 7.1.26, and nine roundings of
/// terms between 1 and 2, 2^-24 each. Largest error at 80 million points: 6.4e-7.
SHARED_FUNCTION float errorFunction(float x) {
    float t = SHARED_FLOAT(1.0) / (SHARED_FLOAT(1.0) + SHARED_FLOAT(0.3275911) * x);
    float series =
        t * (SHARED_FLOAT(0.254829592) +
             t * (SHARED_FLOAT(-0.284496736) +
                  t * (SHARED_FLOAT(1.421413741) + t * (SHARED_FLOAT(-1.453152027) + t * SHARED_FLOAT(1.061405429)))));
    return SHARED_FLOAT(1.0) - series * exp(-x * x);
}

/// The exposure from the opening until u, as a share of the whole: F(u), the integral of w over [0, u] by that over
/// [0, 1]. F(0) = 0, F(1/2) = 1/2 and F(1) = 1 but for a rounding. The share of [a, b] is F(b) - F(a). Error of the
/// Gaussian at most 7e-7 / erf(1 / (2^1.5 width)), which is 7e-7 at the width 1/6 and 4e-6 at 2.
SHARED_FUNCTION float shutterExposure(uint response, float width, float u) {
    if (response == SHUTTER_BOX) return u;
    float off = abs(u - SHARED_FLOAT(0.5));
    // The exposure between the middle and u.
    float beyond = SHARED_FLOAT(2.0) * off * (SHARED_FLOAT(1.0) - off);
    if (response == SHUTTER_GAUSSIAN) {
        float scale = SHARED_FLOAT(0.70710678) / width;
        beyond = SHARED_FLOAT(0.5) * errorFunction(off * scale) / errorFunction(SHARED_FLOAT(0.5) * scale);
    }
    return u < SHARED_FLOAT(0.5) ? SHARED_FLOAT(0.5) - beyond : SHARED_FLOAT(0.5) + beyond;
}

SHARED_END
