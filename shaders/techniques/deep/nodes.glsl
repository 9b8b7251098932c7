// The visibility function of each texel of the map, as its nodes (shared/visibility_function.shared.h).
#include "lib/texel_lists.glsl"
#include "shared/visibility_function.shared.h"

uniform usamplerBuffer nodeOffsets;
uniform samplerBuffer nodes;

// The share of the exposure during which nothing in this texel was nearer to the light than `depth`.
float visibilityAt(ivec2 texel, float depth) {
    ivec2 span = listSpan(nodeOffsets, listNumber(texel));
    if (span.x == span.y) return 1.0;
    vec2 last = texelFetch(nodes, span.y - 1).xy, before = vec2(0.0, 1.0);
    if (last.x < depth) return last.y;
    // The first node that is not nearer than `depth` is among those from `span.x` to `span.y`; `last` is at span.y, and
    // `before` the one in front of span.x.
    --span.y;
    while (span.x < span.y) {
        int middle = (span.x + span.y) / 2;
        vec2 node = texelFetch(nodes, middle).xy;
        if (node.x < depth) {
            span.x = middle + 1;
            before = node;
        } else {
            span.y = middle;
            last = node;
        }
    }
    return before.x > 0.0 ? visibilityBetween(before, last, depth) : 1.0;
}

ListSummary summaryOf(ivec2 texel) {
    ivec2 span = listSpan(nodeOffsets, listNumber(texel));
    ListSummary list = emptySummary();
    list.entries = span.y - span.x;
    return list;
}
