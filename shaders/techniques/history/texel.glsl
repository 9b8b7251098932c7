// What a texel of the history holds; as published.frag has it, something else. x: sum of weight times lit. y: sum of
// weights; 0 where there is no past. z: distance of the surface along the ray of its image position. w: frames merged,
// how many of the last were sure of every sample, and the number of the stratum it was seen in.
#include "shared/history.shared.h"

// A finite share in [0, 1] at a distance in front of the camera: every comparison fails for a NaN.
bool plausible(vec4 h) {
    return h.y > 0.0 && h.y <= HISTORY_PROVEN_WEIGHT && h.x >= 0.0 && h.x <= h.y * 1.00001 && h.z > 0.0 && h.z < 1e30 &&
           h.w >= 0.0 && h.w < 16777216.0;
}

float ageOf(vec4 h) { return floor(h.w / float(1 << (HISTORY_STRATUM_BITS + HISTORY_SURE_BITS))); }
uint sureOf(vec4 h) { return (uint(h.w) >> HISTORY_STRATUM_BITS) & HISTORY_MAX_SURE; }
uint stratumOf(vec4 h) { return uint(h.w) & uint((1 << HISTORY_STRATUM_BITS) - 1); }
float packedAge(float age, uint sure, uint stratum) {
    float ageAndSure = min(age, HISTORY_MAX_AGE) * float(1 << HISTORY_SURE_BITS) + float(sure);
    return ageAndSure * float(1 << HISTORY_STRATUM_BITS) + float(stratum);
}
