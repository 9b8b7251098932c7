// Where the triangles cover whose material is cut out by its alpha (docs/numerics.md, "Cut-outs").
//
// CUTOUTS: the scene has such materials. Without, every triangle covers, and nothing is fetched.
#include "shared/frame_blocks.shared.h"

#ifdef CUTOUTS
#include "shared/cutout.shared.h"

// By names of their own, as not every shader has the others.
layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer positionsOfCutouts;
layout(binding = TRIANGLE_SHADING_UNIT) uniform samplerBuffer shadingOfCutouts;
layout(binding = CUTOUT_MATERIALS_UNIT) uniform usamplerBuffer cutoutMaterials;
layout(binding = CUTOUT_ALPHAS_UNIT) uniform usamplerBuffer cutoutAlphas;

// The record of a triangle's material.
uvec4 cutoutOf(uint id) {
    float material = texelFetch(positionsOfCutouts, int(id) * TRIANGLE_POSITION_TEXELS + 4).w;
    return texelFetch(cutoutMaterials, int(material));
}

bool isCutOut(uint id) { return (cutoutOf(id).w & CUTOUT_PRESENT) != 0u; }

float cutoutAlpha(uvec4 cutout, int width, int x, int y) {
    return float(texelFetch(cutoutAlphas, int(cutout.z) + y * width + x).x);
}

// Does the triangle cover at the point with these barycentrics, which need not be normalised?
bool cutoutCovers(uint id, vec3 weights) {
    uvec4 cutout = cutoutOf(id);
    if ((cutout.w & CUTOUT_PRESENT) == 0u) return true;
    int first = int(id) * TRIANGLE_SHADING_TEXELS;
    vec2 t0 = texelFetch(shadingOfCutouts, first + 4).zw;
    vec4 others = texelFetch(shadingOfCutouts, first + 5);
    ivec2 size = ivec2(cutout.y & 0xffffu, cutout.y >> 16u);
    CutoutTexels t = cutoutTexels(weightedCoordinates(t0, others.xy, others.zw, weights), size, cutout.w);
    vec4 alphas = vec4(cutoutAlpha(cutout, size.x, t.low.x, t.low.y), cutoutAlpha(cutout, size.x, t.high.x, t.low.y),
                       cutoutAlpha(cutout, size.x, t.low.x, t.high.y), cutoutAlpha(cutout, size.x, t.high.x, t.high.y));
    return alphaBetween(alphas, t.share) >= uintBitsToFloat(cutout.x);
}
#else
bool isCutOut(uint id) { return false; }
bool cutoutCovers(uint id, vec3 weights) { return true; }
#endif
