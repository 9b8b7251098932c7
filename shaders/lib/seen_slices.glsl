// Slices: the parts of the shutter in which what a position sees is solved, one by one. A position's first slices are
// one a bucket of time; `next` leads from each to what follows in time. A slice that could not be solved at once is
// empty, and two halves follow it.
#include "shared/sample_pattern.shared.h"
#include "shared/seen_slices.shared.h"

uniform uint firstPlace, places;  // of the batch: position by position, in each the pixels row by row from the bottom

struct Slice {
    float begin, end;  // ticks
    uint place;        // from firstPlace on
    uint next;
    uint first, count;  // segments; none: what is static throughout
};

layout(std430, binding = SEEN_SLICES_BINDING) buffer SeenSlices { Slice slices[]; };
// Segments of slices. x: triangle, y: the tick at which it ends.
layout(std430, binding = SEEN_SEGMENTS_BINDING) buffer SeenSegments { uvec2 seenSegments[]; };
layout(std430, binding = SEEN_COUNTS_BINDING) buffer SeenCounts {
    uint partCount;
    uint sliceCount;
    uint segmentCount;
    uint unsolved;  // what the driver has not let come to its end
};

struct SeenPlace {
    uvec2 pixel;
    uint position;
    vec2 inPixel;
};

SeenPlace seenPlace(uint number) {
    SeenPlace p;
    uint pixels = frame.imageSize.x * frame.imageSize.y;
    p.position = number / pixels;
    uint pixel = number - p.position * pixels;
    p.pixel.y = pixel / frame.imageSize.x;
    p.pixel.x = pixel - p.pixel.y * frame.imageSize.x;
    p.inPixel = cameraSample(p.pixel, p.position, frame.seed, frame.pixelCentres).xy;
    return p;
}

// Two rounds, which no compiler foresees. Some drivers end the loops of an invocation, and of those that run beside it,
// after so many rounds (65,535), silently, but still let each have one.
uniform int twoRounds;
bool areLoopsGoing() {
    int rounds = 0;
    for (int i = twoRounds; i > 0; --i) ++rounds;
    return rounds == twoRounds;
}
