// What one position of the picture sees during the shutter: a partition of [0, 1] into segments, each with the triangle
// that is nearest throughout it, or with none. Every segment is written as one part, or cut at the borders of strata.
//
// A segment's ends are whole ticks, so that each end is the next begin, bit for bit. Candidates come in ascending order
// of their numbers; where the room for segments does not suffice, the time is halved and the candidates are read again.
// Some drivers end an invocation's loops after so many rounds (65,535 for 16 pixels), silently: a position that takes
// long is left before, and the next draw goes on with it. Where the loops were ended all the same, the draw counts for
// nothing, and is made again with fewer rounds.
//
// The parts of a position follow each other in chunks: `count` of them from `first` on, and if SEEN_PARTS_GO_ON is set
// in the count, after them a record (SEEN_NO_PLACE, first, count, 0) that says where the next chunk is.
//
// CAMERA_TURNS: the view does. CUT_AT_STRATA: parts end where a stratum does. MOVING_TRIANGLES: there are such before
// the camera. GOES_ON: only positions that an earlier draw has left.
#include "lib/blocks.glsl"
#include "shared/sample_pattern.shared.h"
#include "shared/time_union.shared.h"
#ifdef MOVING_TRIANGLES
#include "lib/seen_partition.glsl"
#endif

layout(binding = SAMPLE_IDS_UNIT) uniform usampler2DArray sampleIds;  // of what is static
uniform sampler2DArray staticDepth;
uniform uint position;  // 0 .. frame.positions - 1
uniform uint room;      // for parts
uniform int roundsAtOnce;

layout(std430, binding = SEEN_PARTS_BINDING) writeonly buffer SeenParts { uvec4 parts[]; };
layout(std430, binding = SEEN_COUNTS_BINDING) buffer SeenCounts {
    uint partCount;  // with the records between chunks
    uint unfinished;
    uint halvings;
    uint advances;  // positions that came on
};
// A position that is left: from and to where it is to go on, in ticks; the triangle that is seen there, and since when;
// and one more than the place of the record after the last chunk, 0 where there is none yet.
struct SeenState {
    float from, to;
    uint openId;
    float openBegin;
    uint link;
};
layout(std430, binding = SEEN_STATES_BINDING) buffer SeenStates { SeenState states[]; };

layout(location = 0) out uvec2 outputParts;  // first, count

float strataBorder(uint k) { return k >= frame.strata ? TICKS : floor(float(k) / float(frame.strata) * TICKS + 0.5); }

uint stratumOf(float tick) {
    uint k = min(uint(tick / TICKS * float(frame.strata)), frame.strata - 1u);
    if (tick >= strataBorder(k + 1u)) ++k;
    if (k > 0u && tick < strataBorder(k)) --k;
    return k;
}

// How many parts a segment becomes.
uint partsOf(float begin, float end) {
#ifdef CUT_AT_STRATA
    return stratumOf(end - 1.0) - stratumOf(begin) + 1u;
#else
    return 1u;
#endif
}

void writePart(uint at, uvec4 part) {
    if (at < room) parts[at] = part;
}

uint writeParts(uint next, uint placeNumber, uint id, float begin, float end) {
#ifdef CUT_AT_STRATA
    uint first = stratumOf(begin), last = stratumOf(end - 1.0);
    for (uint k = first; k <= last; ++k) {
        float a = max(begin, strataBorder(k)), b = min(end, strataBorder(k + 1u));
        writePart(next, uvec4(placeNumber, id, floatBitsToUint(a / TICKS), floatBitsToUint(b / TICKS)));
        ++next;
    }
    return next;
#else
    writePart(next, uvec4(placeNumber, id, floatBitsToUint(begin / TICKS), floatBitsToUint(end / TICKS)));
    return next + 1u;
#endif
}

#ifdef MOVING_TRIANGLES
#define SEGMENTS_KEPT 40  // more than a partition has

// Segments that are finished and not yet written.
uint keptIds[SEGMENTS_KEPT];
float keptEnds[SEGMENTS_KEPT];
int kept;
float keptFrom;  // where the first of them begins

// The one that is not finished: it may go on.
uint openId;
float openBegin;

uint placeNumber, link, halved;
bool isLooping = false;  // false: the driver has ended the loops
uvec2 firstChunk;  // x: where it is; y: parts in it, 0 where there is none

// Two rounds, which no compiler knows to be two: a driver that ends loops still lets each have one.
bool areLoopsGoing() {
    int rounds = 0;
    for (int i = min(roundsAtOnce, 2); i > 0; --i) ++rounds;
    return rounds == min(roundsAtOnce, 2);
}

void keepSegment(float end) {
    keptIds[kept] = openId;
    keptEnds[kept] = end;
    ++kept;
}

// Writes what is kept. `isLast`: no chunk follows.
void writeChunk(bool isLast) {
    uint count = 0u;
    float begin = keptFrom;
    for (int k = 0; k < kept; ++k) {
        count += partsOf(begin, keptEnds[k]);
        begin = keptEnds[k];
    }
    uint start = atomicAdd(partCount, isLast ? count : count + 1u), at = start;
    begin = keptFrom;
    for (int k = 0; k < kept; ++k) {
        at = writeParts(at, placeNumber, keptIds[k], begin, keptEnds[k]);
        begin = keptEnds[k];
    }
    keptFrom = begin;
    kept = 0;
    uint chunk = isLast ? count : count | SEEN_PARTS_GO_ON;
    if (link > 0u)
        writePart(link - 1u, uvec4(SEEN_NO_PLACE, start, chunk, 0u));
    else
        firstChunk = uvec2(start, chunk);
    link = at + 1u;
}

void keepPartition() {
    float begin = from;
    for (int k = first; k < first + segments; ++k) {
        uint id = staticId;
        if (numbers[k] != STATIC_TRIANGLE) id = texelFetch(seenTriangleIds, int(numbers[k])).x;
        if (begin == 0.0) openId = id;
        if (id != openId) {
            keepSegment(begin);
            openId = id;
            openBegin = begin;
        }
        begin = ends[k];
    }
}

float endOfBucket(float tick) { return floor(float(bucketOf(tick) + 1u) / float(buckets) * TICKS + 0.5); }

// From `from` on, as far as it gets.
void walk(uvec2 pixel, vec2 inTile) {
    while (from < TICKS && partitionRounds < roundsAtOnce) {
        float end = endOfBucket(from);
        beginPartition();
        insertCandidates(tileSpan(pixel, bucketOf(from)), inTile, 6 * roundsAtOnce);
        float width = to - from;
        if (isFull) {
            to = from + max(floor(0.5 * width), 1.0);
            ++halved;
            continue;
        }
        ONLY_IF(kept + segments > SEGMENTS_KEPT) writeChunk(false);
        keepPartition();
        from = to;
        to = from < end ? min(end, from + 2.0 * width) : endOfBucket(from);
    }
}

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec2 inPixel = cameraSample(pixel, position, frame.seed, frame.pixelCentres).xy;
    uint state = pixel.y * frame.imageSize.x + pixel.x;
    placeNumber = state * frame.positions + position;
    staticId = texelFetch(sampleIds, ivec3(pixel, position), 0).x;
    bool isSolved = anyCandidates(pixel);
    outputParts = uvec2(0u);
    from = openBegin = keptFrom = 0.0;
    to = endOfBucket(0.0);
    link = 0u;
#ifdef GOES_ON
    SeenState left = states[state];
    from = left.from;
    to = left.to;
    openId = left.openId;
    openBegin = keptFrom = left.openBegin;
    link = left.link;
    if (!isSolved || from >= TICKS) discard;
#else
    ONLY_IF(!isSolved) {
        uint whole = partsOf(0.0, TICKS), start = atomicAdd(partCount, whole);
        writeParts(start, placeNumber, staticId, 0.0, TICKS);
        outputParts = uvec2(start, whole);
    }
#endif
    bool hadChunk = link > 0u;
    ONLY_IF(isSolved) {
        place = (vec2(pixel) + inPixel) / cameraView.size;
        float stored = texelFetch(staticDepth, ivec3(pixel, position), 0).x;
        staticDistance = stored > 0.0 ? cameraView.nearDistance / stored : 0.0;
        kept = 0;
        halved = 0u;
        SeenState before = SeenState(from, to, openId, openBegin, link);
        firstChunk = uvec2(0u);
        walk(pixel, (vec2(pixel % tileSide) + inPixel) / float(tileSide));
        bool isLast = from >= TICKS;
        if (isLast) keepSegment(TICKS);
        ONLY_IF(kept > 0) writeChunk(isLast);
        isLooping = areLoopsGoing();
        bool isStuck = !isLooping || (from == before.from && to == before.to);
        if (!isLooping || !isLast) atomicAdd(unfinished, 1u);
        if (!isStuck) atomicAdd(advances, 1u);
        if (isLooping) states[state] = SeenState(from, to, openId, openBegin, link);
#ifndef GOES_ON
        if (!isLooping) states[state] = before;
#endif
        if (halved > 0u) atomicAdd(halvings, halved);
        outputParts = firstChunk;
    }
#ifdef GOES_ON
    if (hadChunk || !isLooping) discard;  // the first is known, or nothing is
#endif
}
#else
void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint number = (pixel.y * frame.imageSize.x + pixel.x) * frame.positions + position;
    uint whole = partsOf(0.0, TICKS), start = atomicAdd(partCount, whole);
    writeParts(start, number, texelFetch(sampleIds, ivec3(pixel, position), 0).x, 0.0, TICKS);
    outputParts = uvec2(start, whole);
}
#endif
