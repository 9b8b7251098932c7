#ifdef __cplusplus
#pragma once
#endif
#include "shared/hash.shared.h"

SHARED_BEGIN

#define SALT_CAMERA 0x00000000u  // which view a pattern is drawn for: no two share their random numbers
#define SALT_LIGHT 0x9e3779b9u
#define SALT_INTERVALS 0x3c6ef372u

/// x, y: position inside the pixel, in [0, 1). z: position inside the stratum of time, in [0, 1).
/// x, y: per pixel a random shift (Cranley and Patterson 1976), over k an additive recurrence, the plane's R2 sequence
/// (steps 1/g and 1/g^2 with g^3 = g + 1). z: independent per pixel and stratum, as in plain stratified sampling:
/// a recurrence over k would tie strata to each other (a golden-ratio step all but repeats after 13). So one sample
/// lies in every stratum of time, a pixel's samples are spread evenly in space, and pixels are independent.
SHARED_FUNCTION vec3 samplePattern(uvec2 pixel, uint k, uint seed, uint salt) {
    // The seed is mixed beforehand: words that differ in high bits alone, hashWords leaves nearly as they were.
    uvec3 shift = hashWords(uvec3(pixel.x, pixel.y, hashWord(seed ^ salt)));
    return vec3(unitInterval(shift.x + k * 0xc13fa9a9u), unitInterval(shift.y + k * 0x91e10da5u),
                unitInterval(hashWord(shift.z + k * 0x9e3779b9u)));
}

/// The pattern of a camera sample. `pixelCentres` as in FrameBlock: not 0 puts it at the pixel's centre, at the same
/// time. All that must know where a camera sample lies calls this.
SHARED_FUNCTION vec3 cameraSample(uvec2 pixel, uint k, uint seed, uint pixelCentres) {
    vec3 pattern = samplePattern(pixel, k, seed, SALT_CAMERA);
    if (pixelCentres != 0u) pattern = vec3(SHARED_FLOAT(0.5), SHARED_FLOAT(0.5), pattern.z);
    return pattern;
}

/// Shutter time of the sample in stratum k: u = base + (k + xi) * scale. With base 0 and scale 1/N these are the
/// stratified sample times of docs/numerics.md; scale 0 puts every sample at the instant `base`. Never above 1,
/// whatever 1/N rounds to.
SHARED_FUNCTION float sampleTime(float base, float scale, uint k, float xi) {
    return min(base + (float(k) + xi) * scale, SHARED_FLOAT(1.0));
}

/// Which of side^2 fixed times of a stratum a texel has: 0 .. side^2 - 1, the same in every block of side x side
/// texels.
SHARED_FUNCTION uint texelPhase(uvec2 texel, uint side) { return texel.x % side + side * (texel.y % side); }

/// Where in its stratum the time of a phase lies: the centre of the phase's own part of it, in (0, 1).
SHARED_FUNCTION float phaseTime(uint phase, uint side) {
    return (float(phase) + SHARED_FLOAT(0.5)) / float(side * side);
}

SHARED_END
