// One tuple per triangle and texel as published: from the prism's first fragment in time to its last, in a linked list.
//
// COVERAGE_MAP: none where the coverage map has a triangle.
#include "shared/linked_intervals.shared.h"
#include "techniques/temporal/bindings.shared.h"
#include "techniques/temporal/published_prism.glsl"

layout(std430, binding = LINKED_HEADS_BINDING) buffer Heads { uint heads[]; };
layout(std430, binding = LINKED_TUPLES_BINDING) writeonly buffer Tuples { uint tuples[]; };
layout(std430, binding = TUPLE_COUNTS_BINDING) buffer Counts {
    uint tupleCount;
    uint skippedTuples;
};
uniform uint capacity;
#ifdef COVERAGE_MAP
uniform sampler2DArray coverageMap;
#endif

void main() {
    PrismHits hits = prismHits();
    if (hits.count == 0) discard;
#ifdef COVERAGE_MAP
    if (texelFetch(coverageMap, ivec3(gl_FragCoord.xy, 0), 0).x >= 0.0) {
        atomicAdd(skippedTuples, 1u);
        return;
    }
#endif
    uint tuple = atomicAdd(tupleCount, 1u);
    if (tuple >= capacity) return;  // drawn again with more room
    uint before = atomicExchange(heads[uint(gl_FragCoord.y) * frame.mapWidth + uint(gl_FragCoord.x)], tuple);
    uint at = tuple * uint(LINKED_INTERVAL_WORDS);
    tuples[at] = floatBitsToUint(hits.first.time);
    tuples[at + 1u] = floatBitsToUint(hits.last.time);
    tuples[at + 2u] = floatBitsToUint(hits.first.depth);
    tuples[at + 3u] = floatBitsToUint(hits.last.depth);
    tuples[at + 4u] = triangleId;
    tuples[at + 5u] = before;
}
