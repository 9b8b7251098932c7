#ifdef __cplusplus
#pragma once
#endif
#include "shared/frame_blocks.shared.h"

// How alpha is read that cuts out parts of a triangle (docs/numerics.md, "Cut-outs"): from the image as the file has
// it, by whole texels, never by a device's filter, so that all techniques and all devices see one outline.

// A material's record is four words: the threshold's bits, width and height in 16 bits each, the first byte of its
// alphas, and these flags beside those of TEXTURE_WRAP.
#define CUTOUT_PRESENT 1u  // else the material covers all over
#define CUTOUT_NEAREST 2u

SHARED_BEGIN

/// Of three texture coordinates the mean with these weights, of one sign and any sum but 0. Where all three are equal,
/// exactly that.
SHARED_FUNCTION vec2 weightedCoordinates(vec2 t0, vec2 t1, vec2 t2, vec3 weights) {
    float sum = weights.x + weights.y + weights.z;
    return t0 + ((t1 - t0) * weights.y + (t2 - t0) * weights.z) / sum;
}

/// A texture coordinate as a place in the image, in texels: from 0 to size, or up to a texel beyond where it clamps. No
/// number: 0.
SHARED_FUNCTION float cutoutPlaceOf(float coordinate, float size, uint wrap) {
    float t = coordinate;
    if (!(abs(t) < SHARED_FLOAT(1e9))) t = SHARED_FLOAT(0.0);
    if (wrap == TEXTURE_REPEATS) t = t - floor(t);
    if (wrap == TEXTURE_MIRRORS) {
        t = t - SHARED_FLOAT(2.0) * floor(SHARED_FLOAT(0.5) * t);
        t = min(t, SHARED_FLOAT(2.0) - t);
    }
    return clamp(t * size, SHARED_FLOAT(-1.0), size + SHARED_FLOAT(1.0));
}

/// The texel of that number, which is at most one beyond the image.
SHARED_FUNCTION int cutoutTexelOf(int number, int size, uint wrap) {
    if (wrap == TEXTURE_REPEATS) return number < 0 ? number + size : (number >= size ? number - size : number);
    return min(max(number, 0), size - 1);  // a mirrored image repeats its border texel there
}

/// Four texels, the first of each pair and the second, and how far it is from the one to the other, in [0, 1).
struct CutoutTexels {
    ivec2 low, high;
    vec2 share;
};

SHARED_FUNCTION CutoutTexels cutoutTexels(vec2 coordinates, ivec2 size, uint flags) {
    uint wrapU = (flags >> TEXTURE_WRAP_U_SHIFT) & TEXTURE_WRAP;
    uint wrapV = (flags >> TEXTURE_WRAP_V_SHIFT) & TEXTURE_WRAP;
    vec2 place =
        vec2(cutoutPlaceOf(coordinates.x, float(size.x), wrapU), cutoutPlaceOf(coordinates.y, float(size.y), wrapV));
    bool one = (flags & CUTOUT_NEAREST) != 0u;
    if (!one) place = place - vec2(SHARED_FLOAT(0.5));
    vec2 first = floor(place);
    int step = one ? 0 : 1;
    CutoutTexels t;
    t.share = one ? vec2(SHARED_FLOAT(0.0)) : place - first;
    t.low = ivec2(cutoutTexelOf(int(first.x), size.x, wrapU), cutoutTexelOf(int(first.y), size.y, wrapV));
    t.high =
        ivec2(cutoutTexelOf(int(first.x) + step, size.x, wrapU), cutoutTexelOf(int(first.y) + step, size.y, wrapV));
    return t;
}

/// The alpha between the four (low low, high low, low high, high high), in their units. Of equal ones exactly that.
SHARED_FUNCTION float alphaBetween(vec4 alphas, vec2 share) {
    float low = alphas.x + (alphas.y - alphas.x) * share.x, high = alphas.z + (alphas.w - alphas.z) * share.x;
    return low + (high - low) * share.y;
}

SHARED_END
