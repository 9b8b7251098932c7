// Depth of what is left of triangles that are cut out by their alpha, and of all others.
//
// OUTPUT_TRIANGLE: write the triangle's number as well.
#include "lib/cutouts.glsl"

flat in uint casterTriangle;
in vec3 casterWeights;
#ifdef OUTPUT_TRIANGLE
layout(location = 0) out uint outputTriangle;
#endif

void main() {
    if (!cutoutCovers(casterTriangle, casterWeights)) discard;
#ifdef OUTPUT_TRIANGLE
    outputTriangle = casterTriangle;
#endif
}
