// Reading the published forms' linked lists (shared/linked_intervals.shared.h).
#include "lib/light_projection.glsl"
#include "lib/texel_lists.glsl"
#include "shared/linked_intervals.shared.h"

struct LinkedInterval {
    float begin, end;            // u
    float depthBegin, depthEnd;  // NDC depth, reversed: greater is nearer
    uint id, next;
};

LinkedInterval fetchInterval(usamplerBuffer intervals, uint entry) {
    int word = int(entry) * LINKED_INTERVAL_WORDS;
    return LinkedInterval(
        uintBitsToFloat(texelFetch(intervals, word).x), uintBitsToFloat(texelFetch(intervals, word + 1).x),
        uintBitsToFloat(texelFetch(intervals, word + 2).x), uintBitsToFloat(texelFetch(intervals, word + 3).x),
        texelFetch(intervals, word + 4).x, texelFetch(intervals, word + 5).x);
}

// Is a triangle other than `own` nearer to the light than `depth` (a distance) at time u, in the list that begins with
// entry `head`, and does it cover `place` of the map? As published, NDC depth is taken as linear in u between the
// interval's ends.
bool nearerInLinkedList(usamplerBuffer intervals, uint head, vec2 place, float depth, uint own, float u) {
    float receiver = ndcDepth(max(depth, lightView.nearDistance));  // orthographic: the near distance is 0
    for (uint next = head; next != NO_INTERVAL;) {
        LinkedInterval i = fetchInterval(intervals, next);
        next = i.next;
        if (i.id == own || u < i.begin || u > i.end) continue;
        float share = clamp((u - i.begin) / max(i.end - i.begin, 1e-20), 0.0, 1.0);
        if (mix(i.depthBegin, i.depthEnd, share) > receiver && cutoutCoversLight(i.id, place, u)) return true;
    }
    return false;
}

ListSummary summaryOfLinkedList(usamplerBuffer intervals, uint head) {
    ListSummary summary = emptySummary();
    for (uint next = head; next != NO_INTERVAL;) {
        LinkedInterval i = fetchInterval(intervals, next);
        next = i.next;
        ++summary.entries;
        summary.firstTime = min(summary.firstTime, i.begin);
    }
    return summary;
}
