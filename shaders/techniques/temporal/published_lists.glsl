// The published form's lists: tuples in linked lists; included by lists.glsl.
#include "lib/linked_intervals.glsl"

uniform usamplerBuffer tupleHeads;
uniform usamplerBuffer linkedTuples;
#ifdef COVERAGE_MAP
uniform sampler2DArray coverageMap;
#endif

uint headOf(ivec2 texel) { return texelFetch(tupleHeads, listNumber(texel)).x; }

// Is a triangle other than the receiver's own nearer to the light than `depth`, in this texel at this time?
bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float time) {
#ifdef COVERAGE_MAP
    float covered = texelFetch(coverageMap, ivec3(texel, 0), 0).x;
    if (covered == float(own)) return false;
    if (covered > -1.0) return true;
#endif
    return nearerInLinkedList(linkedTuples, headOf(texel), m.position, depth, own, time);
}

ListSummary summaryOf(ivec2 texel) { return summaryOfLinkedList(linkedTuples, headOf(texel)); }
