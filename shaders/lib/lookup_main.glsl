// KEEP_STILL: asks about what stands still, by casters that do, and keeps where in the light's map each sample is.
layout(location = 0) out float outputLit;
#ifdef KEEP_STILL
layout(location = 1) out uint outputCell;

uint cellOf(Receiver r) {
    ivec2 place = clamp(ivec2(floor(mapPointOf(r, r.time).position * float(REACHED_SIDE))), ivec2(0), ivec2(REACHED_SIDE - 1));
    return uint(place.y * REACHED_SIDE + place.x);
}
#endif

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputLit = 1.0;
#ifdef KEEP_STILL
    outputCell = NO_CELL;
#endif
    if (id == NO_TRIANGLE) return;
    MovingTriangle t = fetchTriangle(id);
    Receiver r = receiverOf(t, id, pixel, stratum);
    outputLit = 0.0;
    if (!facesLight(r)) return;
    outputLit = litOf(t, r);
#ifdef KEEP_STILL
    outputCell = cellOf(r);
#endif
}
