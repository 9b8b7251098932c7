// CACHE_STATIC: asks about what stands still, by casters that do, and says where in the light's map each sample is: cell x and y, and what is left
// beyond them, so that the least of all samples bounds a pixel.
layout(location = 0) out float outputLit;
#ifdef CACHE_STATIC
layout(location = 1) out vec4 outputCells;

vec4 cellsOf(Receiver r) {
    vec2 cell = clamp(floor(mapPointOf(r, r.time).position * float(REACHED_SIDE)), vec2(0.0), vec2(REACHED_SIDE - 1));
    return vec4(cell, float(REACHED_SIDE - 1) - cell);
}
#endif

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputLit = 1.0;
#ifdef CACHE_STATIC
    outputCells = vec4(NO_CELL);
#endif
    if (id == NO_TRIANGLE) return;
    MovingTriangle t = fetchTriangle(id);
    Receiver r = receiverOf(t, id, pixel, stratum);
    outputLit = 0.0;
    if (!facesLight(r)) return;
    outputLit = litOf(t, r);
#ifdef CACHE_STATIC
    outputCells = cellsOf(r);
#endif
}
