// What positions see during slices of the shutter, an invocation one slice: a partition of it into segments, each with
// the triangle that is nearest throughout, or with none. A segment's ends are whole ticks, so that each end is the next
// begin, bit for bit. Where a partition finds no room, or the driver has ended the loops, nothing of it is used: two
// slices of half the length take its place, for the next dispatch.
//
// CAMERA_TURNS: the view does.
#include "lib/blocks.glsl"

#include "lib/seen_partition.glsl"
#include "lib/seen_slices.glsl"

layout(local_size_x = SEEN_GROUP) in;
#include "lib/work_groups.glsl"

layout(binding = SAMPLE_IDS_UNIT) uniform usampler2DArray sampleIds;  // of what is static
uniform sampler2DArray staticDepth;
uniform uint sliceRoom, segmentRoom;
uniform uint sliceBegin, sliceEnd;  // those to be solved
uniform uint apart;  // one of so many invocations has something to do: alone, its loops may have more rounds

float bucketBegin(uint bucket) { return floor(float(bucket) / float(buckets) * TICKS + 0.5); }

Slice firstSlice(uint number) {
    uint bucket = number / places;
    return Slice(bucketBegin(bucket), bucketBegin(bucket + 1u), number - bucket * places,
                 bucket + 1u < buckets ? number + places : SEEN_NO_SLICE, 0u, 0u);
}

void writeSlice(uint number, Slice slice) {
    if (number < sliceRoom) slices[number] = slice;
}

void halve(uint number, Slice slice) {
    float middle = floor(0.5 * (slice.begin + slice.end));
    if (middle == slice.begin) {
        atomicAdd(unsolved, 1u);
        middle = slice.end;
    }
    uint half0 = atomicAdd(sliceCount, 2u);
    writeSlice(number, Slice(slice.begin, slice.begin, slice.place, half0, 0u, 0u));
    writeSlice(half0, Slice(slice.begin, middle, slice.place, half0 + 1u, 0u, 0u));
    writeSlice(half0 + 1u, Slice(middle, slice.end, slice.place, slice.next, 0u, 0u));
}

// Writes the partition's segments; returns the first.
uint writeSegments() {
    uint start = atomicAdd(segmentCount, uint(segments));
    for (int k = 0; k < segments; ++k) {
        uint number = numbers[first + k], id = staticId;
        if (number != STATIC_TRIANGLE) id = texelFetch(seenTriangleIds, int(number)).x;
        if (start + uint(k) < segmentRoom) seenSegments[start + uint(k)] = uvec2(id, floatBitsToUint(ends[first + k]));
    }
    return start;
}

void main() {
    uint number = sliceBegin + invocationIndex() / apart;
    if (invocationIndex() % apart != 0u || number >= sliceEnd) return;
    Slice slice = number < places * buckets ? firstSlice(number) : slices[number];
    SeenPlace at = seenPlace(firstPlace + slice.place);
    ivec2 span = tileSpan(at.pixel, bucketOf(slice.begin));
    from = slice.begin;
    to = slice.end;
    ONLY_IF(span.x < span.y) {
        place = (vec2(at.pixel) + at.inPixel) / cameraView.size;
        staticId = texelFetch(sampleIds, ivec3(at.pixel, at.position), 0).x;
        float stored = texelFetch(staticDepth, ivec3(at.pixel, at.position), 0).x;
        staticDistance = stored > 0.0 ? cameraView.nearDistance / stored : 0.0;
        beginPartition();
        insertCandidates(span, (vec2(at.pixel % tileSide) + at.inPixel) / float(tileSide));
        bool isStatic = segments == 1 && numbers[first] == STATIC_TRIANGLE;
        ONLY_IF(!isFull && !isStatic) {
            slice.first = writeSegments();
            slice.count = uint(segments);
        }
    }
    if (isFull || !areLoopsGoing())
        halve(number, slice);
    else
        writeSlice(number, slice);
}
