#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

SHARED_BEGIN

// Of a texel of the history, in one float's 24 bits: the number of its stratum, how often in a row its tests were sure,
// its age.
#define HISTORY_STRATUM_BITS 5
#define HISTORY_SURE_BITS 3
#define HISTORY_MAX_SURE 7u
#define HISTORY_MAX_AGE 65535.0

// A converged pixel is tested again every second, fourth, ... frame, tile by tile in turn. Packed in one number: the
// first and the last cell that its samples fall in, of RETEST_SIDE x RETEST_SIDE over the light's image plane, 7 bits
// per coordinate; above them the re-test period's power of two.
#define RETEST_SIDE 128
#define RETEST_CELL_BITS 7
#define RETEST_PERIOD_SHIFT 28
#define RETEST_NEVER 15u         // no further test can change the pixel
#define RETEST_SURE_AFTER 4u     // tests in a row that were sure of every sample;
#define RETEST_PERIOD_SURE 5u    // then every thirty-second frame
#define RETEST_DOUBT_AFTER 12.0  // tests of which some were not: an edge is near;
#define RETEST_PERIOD_DOUBT 4u   // then every sixteenth frame
#define RETEST_TILE 8            // pixels along a side of a tile, which have one phase of the period

// Limit of the sum of weights, in frames, so that adding to it in float stays exact enough for any number of frames.
// Twice that marks a pixel that was proven to be shadowed.
#define HISTORY_MAX_WEIGHT 4096.0
#define HISTORY_PROVEN_WEIGHT 8192.0

/// What the shaders of the technique `history` need beside the frame's own blocks.
struct HistoryBlock {
    mat4 mapFromPlane;      // 3 x 3: (s, t, 1) of the light's image plane to this frame's map, homogeneous
    mat4 planeFromMap;      // its inverse
    mat4 previousRaysOpen;  // columns 0..2: the world's ray of (s, t, 1) of the camera one frame ago, at u = 0
    mat4 previousRaysClose;
    vec4 previousEyeOpen;  // xyz
    vec4 previousEyeClose;
    float instant;          // u at which the map is drawn
    float exponent;         // m of equation 6
    float weightScale;      // turns conf^m into a weight whose mean is 1
    float memory;           // the most frames' worth of weight that the past may bring
    float sharpness;        // factor on the distance from one half of what is shown
    float threshold;        // of the distance from the camera: a past farther off its surface is another's
    uint hasPast;           // 0: nothing of the history may be used
    uint triesTriangles;    // 1: the triangles that the map saw are tested against the receiver's own segment
    uint keepsProof;        // 1: what is proven to be shadowed stays so until something moves
    float dynamicMaskSize;  // texels along a side of the mask of dynamic casters; 0: no mask
    uint awaitsProof;       // 1: later frames can find the proof, so that without one a point beside an edge is lit
    uint mayConverge;       // 1: converged pixels are not tested in every frame
    uint round;             // frames since the camera stopped
    uint framesDue;         // converged pixels are tested whose phase falls in one of so many frames
    float previousNear;     // near distance of the camera one frame ago
    uint padding0;
};

/// Equation 5 of Scherzer, Jeschke, Wimmer 2007: 1 where the point falls on a texel's centre, 0 on a texel's border, by
/// the max norm. `position` in texels, with texel i from i to i + 1.
SHARED_FUNCTION float shadowTestConfidence(vec2 position) {
    vec2 fromCentre = abs(fract(position) - SHARED_FLOAT(0.5));
    return SHARED_FLOAT(1.0) - SHARED_FLOAT(2.0) * max(fromCentre.x, fromCentre.y);
}

/// Equation 6, conf^m. Over evenly spread positions its mean is 2 / ((m + 1) (m + 2)).
SHARED_FUNCTION float confidenceWeight(float confidence, float m) { return pow(max(confidence, SHARED_FLOAT(0.0)), m); }

/// What makes the mean weight 1 whatever m is, so that sums over frames with different m weigh all frames alike.
SHARED_FUNCTION float confidenceWeightScale(float m) {
    return SHARED_FLOAT(0.5) * (m + SHARED_FLOAT(1.0)) * (m + SHARED_FLOAT(2.0));
}

/// Equation 3: one step of exponential smoothing.
SHARED_FUNCTION float smoothed(float past, float f, float w) { return w * f + (SHARED_FLOAT(1.0) - w) * past; }

SHARED_END

#ifdef __cplusplus
namespace timeshade::shared {
static_assert(sizeof(HistoryBlock) == 4 * 64 + 2 * 16 + 15 * 4 + 4, "std140 layout changed: fix both readers");
}
#endif
