// The published form's ranges: a linked list per texel; included by lists.glsl.
#include "lib/linked_intervals.glsl"

uniform usamplerBuffer rangeHeads;
uniform usamplerBuffer ranges;

uint headOf(ivec2 texel) { return texelFetch(rangeHeads, listNumber(texel)).x; }

// Is a triangle other than `own` nearer to the light than `depth` at time u, in this texel?
bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float u) {
    return nearerInLinkedList(ranges, headOf(texel), m.position, depth, own, u);
}

ListSummary summaryOf(ivec2 texel) { return summaryOfLinkedList(ranges, headOf(texel)); }
