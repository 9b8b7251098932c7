#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

SHARED_BEGIN

/// Three well mixed words out of three: PCG3D of Jarzynski and Olano, "Hash Functions for GPU Rendering", JCGT 2020.
/// Integer arithmetic only, so every device and the CPU agree on every bit.
SHARED_FUNCTION uvec3 hashWords(uvec3 v) {
    v = v * 1664525u + 1013904223u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    v.x ^= v.x >> 16u;
    v.y ^= v.y >> 16u;
    v.z ^= v.z >> 16u;
    v.x += v.y * v.z;
    v.y += v.z * v.x;
    v.z += v.x * v.y;
    return v;
}

/// One well mixed word out of one: multiply and fold twice, with the constants of Wellons' search for low-bias 32-bit
/// mixers (2018).
SHARED_FUNCTION uint hashWord(uint x) {
    x ^= x >> 16u;
    x *= 0x7feb352du;
    x ^= x >> 15u;
    x *= 0x846ca68bu;
    x ^= x >> 16u;
    return x;
}

/// A word as a number in [0, 1): its upper 24 bits, exactly.
SHARED_FUNCTION float unitInterval(uint word) { return float(word >> 8u) * SHARED_FLOAT(5.9604644775390625e-8); }

SHARED_END
