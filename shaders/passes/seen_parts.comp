// The parts of positions from the segments of their slices, an invocation one position: segments of one triangle that
// follow each other are one. Every segment is written as one part, or cut at the borders of strata.
//
// CUT_AT_STRATA: parts end where a stratum does. MOVING_TRIANGLES: there are such before the camera, and slices.
#include "lib/blocks.glsl"

#include "lib/seen_slices.glsl"
#include "shared/time_union.shared.h"

layout(local_size_x = SEEN_GROUP) in;
#include "lib/work_groups.glsl"

layout(binding = SAMPLE_IDS_UNIT) uniform usampler2DArray sampleIds;  // of what is static
layout(rg32ui) uniform writeonly uimage2DArray partsOfPositions;      // first, count
uniform uint partRoom;
uniform uint apart;  // one of so many invocations has something to do

layout(std430, binding = SEEN_PARTS_BINDING) writeonly buffer SeenParts { uvec4 parts[]; };

float strataBorder(uint k) { return k >= frame.strata ? TICKS : floor(float(k) / float(frame.strata) * TICKS + 0.5); }

uint stratumOf(float tick) {
    uint k = min(uint(tick / TICKS * float(frame.strata)), frame.strata - 1u);
    if (tick >= strataBorder(k + 1u)) ++k;
    if (k > 0u && tick < strataBorder(k)) --k;
    return k;
}

// A position's parts, which are counted first, then written.
uint partPlace;
uint partNext;
bool isWriting;

void addPart(uint id, float begin, float end) {
    if (isWriting && partNext < partRoom)
        parts[partNext] = uvec4(partPlace, id, floatBitsToUint(begin / TICKS), floatBitsToUint(end / TICKS));
    ++partNext;
}

void addSegment(uint id, float begin, float end) {
#ifdef CUT_AT_STRATA
    uint last = stratumOf(end - 1.0);
    for (uint k = stratumOf(begin); k <= last; ++k)
        addPart(id, max(begin, strataBorder(k)), min(end, strataBorder(k + 1u)));
#else
    addPart(id, begin, end);
#endif
}

// Returns the tick at which it ends.
float addSegments(uint place, uint staticId) {
#ifdef MOVING_TRIANGLES
    uint id = staticId;
    float begin = 0.0, end = 0.0;
    for (uint number = place; number != SEEN_NO_SLICE;) {
        Slice slice = slices[number];
        uint count = slice.begin < slice.end ? max(slice.count, 1u) : 0u;
        for (uint k = 0u; k < count; ++k) {
            uvec2 segment = uvec2(staticId, floatBitsToUint(slice.end));
            if (slice.count > 0u) segment = seenSegments[slice.first + k];
            if (segment.x != id && end > 0.0) {
                addSegment(id, begin, end);
                begin = end;
            }
            id = segment.x;
            end = uintBitsToFloat(segment.y);
        }
        number = slice.next;
    }
    addSegment(id, begin, end);
    return end;
#else
    addSegment(staticId, 0.0, TICKS);
    return TICKS;
#endif
}

void main() {
    uint place = invocationIndex() / apart;
    if (invocationIndex() % apart != 0u || place >= places) return;
    SeenPlace at = seenPlace(firstPlace + place);
    uint staticId = texelFetch(sampleIds, ivec3(at.pixel, at.position), 0).x;
    partPlace = (at.pixel.y * frame.imageSize.x + at.pixel.x) * frame.positions + at.position;
    uint start = 0u, count = 0u;
    float end = 0.0;
    for (int pass = 0; pass < twoRounds; ++pass) {
        isWriting = pass == 1;
        partNext = start;
        end = addSegments(place, staticId);
        if (!isWriting) {
            count = partNext;
            start = atomicAdd(partCount, count);
        }
    }
    imageStore(partsOfPositions, ivec3(at.pixel, at.position), uvec4(start, count, 0u, 0u));
    if (end != TICKS || !areLoopsGoing()) atomicAdd(unsolved, 1u);
}
