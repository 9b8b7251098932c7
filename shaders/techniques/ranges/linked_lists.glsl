// The published form's ranges: a linked list a texel, RANGE_WORDS words a range; included by lists.glsl.
uniform usamplerBuffer rangeHeads;
uniform usamplerBuffer ranges;

struct Range { float begin; float end; float depthBegin; float depthEnd; uint id; uint next; };

float rangeNumber(uint range, int word) { return uintBitsToFloat(texelFetch(ranges, int(range) * RANGE_WORDS + word).x); }

Range fetchRange(uint range) {
    return Range(rangeNumber(range, 0), rangeNumber(range, 1), rangeNumber(range, 2), rangeNumber(range, 3),
                 texelFetch(ranges, int(range) * RANGE_WORDS + 4).x, texelFetch(ranges, int(range) * RANGE_WORDS + 5).x);
}

// Is a triangle other than `own` nearer to the light than `depth` at time u, in this texel? Window depths are taken as linear in
// u; they are reversed, so that nearer is greater.
bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float u) {
#ifdef LIGHT_ORTHOGRAPHIC
    float window = 1.0 - depth / lightView.farDistance;
#else
    float window = lightView.nearDistance / max(depth, lightView.nearDistance);
#endif
    for (uint next = texelFetch(rangeHeads, listNumber(texel)).x; next != NO_ENTRY;) {
        Range range = fetchRange(next);
        next = range.next;
        if (range.id == own || u < range.begin || u > range.end) continue;
        float share = clamp((u - range.begin) / max(range.end - range.begin, 1e-20), 0.0, 1.0);
        if (mix(range.depthBegin, range.depthEnd, share) > window) return true;
    }
    return false;
}

struct ListSummary { int ranges; float firstTime; };

ListSummary summaryOf(ivec2 texel) {
    ListSummary summary = ListSummary(0, 1.0);
    for (uint next = texelFetch(rangeHeads, listNumber(texel)).x; next != NO_ENTRY;) {
        Range range = fetchRange(next);
        next = range.next;
        ++summary.ranges;
        summary.firstTime = min(summary.firstTime, range.begin);
    }
    return summary;
}
