// The parts of interval samples: what a position sees from one time of the shutter to another.
//
// SOLVES_INTERVALS: values are means over a part; else each is of one time in it, random within the stratum.
#include "lib/receiver.glsl"
#include "shared/seen_slices.shared.h"

uniform usamplerBuffer seenParts;

struct SeenPart {
    uvec2 pixel;
    uint position;  // of the pixel's
    uint triangle;
    float begin, end;
    float time;  // that stands for the part
    vec2 place;  // in the image
};

SeenPart seenPart(uint number) {
    uvec4 stored = texelFetch(seenParts, int(number));
    SeenPart p;
    uint pixel = stored.x / frame.positions;
    p.position = stored.x - pixel * frame.positions;
    p.pixel.y = pixel / frame.imageSize.x;
    p.pixel.x = pixel - p.pixel.y * frame.imageSize.x;
    p.triangle = stored.y;
    p.begin = uintBitsToFloat(stored.z);
    p.end = uintBitsToFloat(stored.w);
    p.place = (vec2(p.pixel) + cameraSample(p.pixel, p.position, frame.seed, frame.pixelCentres).xy) / cameraView.size;
#ifdef SOLVES_INTERVALS
    p.time = 0.5 * (p.begin + p.end);
#else
    uint stratum = min(uint(0.5 * (p.begin + p.end) / frame.timeScale), frame.strata - 1u);
    // As many random numbers as a pixel has positions and strata.
    float xi = samplePattern(p.pixel, p.position * frame.strata + stratum, frame.seed, SALT_INTERVALS).z;
    p.time = mix(p.begin, p.end, xi);
#endif
    return p;
}
