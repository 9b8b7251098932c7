#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// How much the light of each instant counts (w(t) of Palmer's equation 2.1).
#define SHUTTER_BOX 0u       // all instants alike
#define SHUTTER_TENT 1u      // rises from 0 where the shutter opens, falls to 0 where it closes
#define SHUTTER_GAUSSIAN 2u  // about the middle of the shutter, cut at its ends

// A response may be that of one of 2^n equal pieces of a shutter: its time u runs over that piece alone.
#define SHUTTER_KIND 3u          // mask of the above
#define SHUTTER_PIECES_SHIFT 2u  // of n, 3 bits
#define SHUTTER_PIECE_SHIFT 5u   // of the piece's number
#define SHUTTER_PIECES_MASK 7u

SHARED_BEGIN

/// The response of piece number `piece` of 2^n. A box is alike in all pieces.
SHARED_FUNCTION uint responseOfPiece(uint kind, uint n, uint piece) {
    return kind == SHUTTER_BOX ? kind : kind | n << SHUTTER_PIECES_SHIFT | piece << SHUTTER_PIECE_SHIFT;
}

/// Where the time u of the response's piece lies in the whole shutter; exact but for one rounding, and u itself where
/// the piece is all of it.
SHARED_FUNCTION float wholeShutterTime(uint response, float u) {
    uint pieces = 1u << (response >> SHUTTER_PIECES_SHIFT & SHUTTER_PIECES_MASK);
    return (float(response >> SHUTTER_PIECE_SHIFT) + u) / float(pieces);
}

/// The shutter's response w at the time u in [0, 1], as a share of that in the middle: of 1 at u = 1/2. `width` is the
/// standard deviation of the Gaussian in the whole shutter, 0.05 .. 2; of the others it is not read. At least 1e-15, so
/// that no sum of weights is 0. Relative error of the Gaussian: that of its exponent and of exp, at most 2^-15.
SHARED_FUNCTION float shutterWeight(uint response, float width, float u) {
    if (response == SHUTTER_BOX) return SHARED_FLOAT(1.0);
    float off = abs(wholeShutterTime(response, u) - SHARED_FLOAT(0.5));
    float weight = SHARED_FLOAT(1.0) - SHARED_FLOAT(2.0) * off;
    if ((response & SHUTTER_KIND) == SHUTTER_GAUSSIAN) {
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
/// [0, 1]. F(0) = 0, F(1/2) = 1/2 and F(1) = 1 but for a rounding. The share of [a, b] is F(b) - F(a). Of a piece both
/// are shares of the whole shutter; a box has u itself, since only quotients of shares are of use. Error of the
/// Gaussian at most 7e-7 / erf(1 / (2^1.5 width)), which is 7e-7 at the width 1/6 and 4e-6 at 2.
SHARED_FUNCTION float shutterExposure(uint response, float width, float u) {
    if (response == SHUTTER_BOX) return u;
    float whole = wholeShutterTime(response, u);
    float off = abs(whole - SHARED_FLOAT(0.5));
    // The exposure between the middle and u.
    float beyond = SHARED_FLOAT(2.0) * off * (SHARED_FLOAT(1.0) - off);
    if ((response & SHUTTER_KIND) == SHUTTER_GAUSSIAN) {
        float scale = SHARED_FLOAT(0.70710678) / width;
        beyond = SHARED_FLOAT(0.5) * errorFunction(off * scale) / errorFunction(SHARED_FLOAT(0.5) * scale);
    }
    return whole < SHARED_FLOAT(0.5) ? SHARED_FLOAT(0.5) - beyond : SHARED_FLOAT(0.5) + beyond;
}

SHARED_END
