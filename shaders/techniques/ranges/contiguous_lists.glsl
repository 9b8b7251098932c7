// The repaired form's ranges: of each texel all in a row, a field an array; included by lists.glsl.
uniform usamplerBuffer listOffsets;
// A range is two places of each array, its beginning and its end: one texel.
uniform samplerBuffer rangeTimes;
uniform samplerBuffer rangeDistances;
uniform usamplerBuffer rangeSlopes;  // of time and distance at the beginning, at the end
uniform usamplerBuffer rangeIds;

// First range of the texel's list, and the one behind its last.
ivec2 listOf(ivec2 texel) {
    int list = listNumber(texel);
    return ivec2(texelFetch(listOffsets, list).x, texelFetch(listOffsets, list + 1).x) / 2;
}

// Is a triangle other than `own` nearer to the light than `depth` at time u, in this texel? Times and distances of a range are those of
// the texel's centre; the prism's surface says how they change from there to the receiver, which places an edge that sweeps over
// texels more finely than the texels are. Between the two ends, distances are linear in u.
bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float u) {
    ivec2 list = listOf(texel);
    vec2 offset = m.position * lightView.size - (vec2(texel) + 0.5);
    bool found = false;
    // No branches inside: where pixels run in step, each would be taken by all.
    for (int range = list.x; range < list.y && !found; ++range) {
        vec2 times = texelFetch(rangeTimes, range).xy, distances = texelFetch(rangeDistances, range).xy;
        uvec4 slopes = texelFetch(rangeSlopes, range);
        float begin = times.x + dot(offset, unpackHalf2x16(slopes.x)), end = times.y + dot(offset, unpackHalf2x16(slopes.z));
        float first = distances.x + texelWidth(distances.x) * dot(offset, unpackHalf2x16(slopes.y));
        float last = distances.y + texelWidth(distances.y) * dot(offset, unpackHalf2x16(slopes.w));
        float distance = mix(first, last, (u - begin) / max(end - begin, 1e-20));
        found = begin <= u && u <= end && depth > distance && texelFetch(rangeIds, range).x != own;
    }
    return found;
}

struct ListSummary { int ranges; float firstTime; };

ListSummary summaryOf(ivec2 texel) {
    ivec2 list = listOf(texel);
    ListSummary summary = ListSummary(0, 1.0);
    for (int range = list.x; range < list.y; ++range) {
        vec2 times = texelFetch(rangeTimes, range).xy;
        if (times.x > times.y) continue;  // empty
        ++summary.ranges;
        summary.firstTime = min(summary.firstTime, times.x);
    }
    return summary;
}
