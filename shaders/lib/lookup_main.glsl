// Draws one stratum of a lookup: calls litOf or litOver of the technique for the sample of each pixel. This is where
// every shadow test begins.
//
// FOOTPRINT_STRATUM, FOOTPRINT_SHUTTER: a value is the mean over a stratum or over the whole shutter. Camera samples of
// different strata have different positions inside the pixel, so each has its own value.
//
// CACHE_STATIC: also writes the cell of the shadow map that each sample is in: x and y, and the distances to the last
// cell, so that the minimum over all samples bounds a pixel's cells.
#ifdef INTERVAL_SAMPLES
uniform uint partCount;
// x: lit, over the times at which the receiver is tested; y: their share of the part; z, w: of the times at which it is
// lit, from 0 to 1 over the part, the mean and the mean of the squares.
layout(location = 0) out vec4 outputLit;
#else
layout(location = 0) out float outputLit;
#endif
#ifdef CACHE_STATIC
layout(location = 1) out vec4 outputCells;

vec4 cellsOf(Receiver r) {
    vec2 cell = clamp(floor(mapPointOf(r, r.time).position * float(REACHED_SIDE)), vec2(0.0), vec2(REACHED_SIDE - 1));
    return vec4(cell, float(REACHED_SIDE - 1) - cell);
}
#endif

float litOfSample(MovingTriangle t, Receiver r) {
#if defined(FOOTPRINT_SHUTTER)
    return litOver(t, r, frame.timeBase, frame.timeBase + float(frame.strata) * frame.timeScale);
#elif defined(FOOTPRINT_STRATUM)
    float begin = frame.timeBase + float(stratum) * frame.timeScale;
    return litOver(t, r, begin, begin + frame.timeScale);
#else
    return litOf(t, r);
#endif
}

#ifdef INTERVAL_SAMPLES
void main() {
    uint number = uint(gl_FragCoord.y) * SEEN_PARTS_IN_ROW + uint(gl_FragCoord.x);
    outputLit = vec4(1.0, 0.0, 0.5, 0.25);
    if (number >= partCount) return;
    SeenPart part = seenPart(number);
    if (part.triangle == NO_TRIANGLE) return;
    MovingTriangle t = fetchTriangle(part.triangle);
#ifdef SOLVES_INTERVALS
    outputLit = litAlong(t, part.triangle, part.place, part.begin, part.end);
#else
    stratum = min(uint(part.time / frame.timeScale), frame.strata - 1u);
    samplePixel = part.pixel;
    Receiver r = receiverOnRay(t, part.triangle, part.place, part.time);
    if (!facesLight(r)) return;
    outputLit.xy = vec2(litOfSample(t, r), 1.0);
#endif
}
#else
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
    outputLit = litOfSample(t, r);
#ifdef CACHE_STATIC
    outputCells = cellsOf(r);
#endif
}
#endif
