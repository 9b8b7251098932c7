// The repaired form's ranges: those of one texel are contiguous, with an array per field; included by lists.glsl.
uniform usamplerBuffer listOffsets;
// A range is two elements of each array, its beginning and its end: one texel of the buffer texture.
uniform samplerBuffer rangeTimes;
uniform samplerBuffer rangeDistances;
// Slopes of time and of distance, at the beginning and at the end.
uniform usamplerBuffer rangeSlopes;
uniform usamplerBuffer rangeIds;

// First range of the texel's list, and the one behind its last.
ivec2 listOf(ivec2 texel) { return listSpan(listOffsets, listNumber(texel)) / 2; }

// Is a triangle other than `own` nearer to the light than `depth` at time u, in this texel? Times and distances of a
// range are those of the texel's centre; the slopes of the prism's surface extrapolate them to the receiver, which
// places an edge that sweeps over texels more finely than the texels are. Between the two ends, distances are linear in
// u.
bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float u) {
    ivec2 list = listOf(texel);
    vec2 offset = m.position * lightView.size - (vec2(texel) + 0.5);
    bool found = false;
    // No branches inside: where pixels run in step, each would be taken by all.
    for (int range = list.x; range < list.y && !found; ++range) {
        vec2 times = texelFetch(rangeTimes, range).xy, distances = texelFetch(rangeDistances, range).xy;
        uvec4 slopes = texelFetch(rangeSlopes, range);
        float begin = times.x + dot(offset, unpackHalf2x16(slopes.x));
        float end = times.y + dot(offset, unpackHalf2x16(slopes.z));
        float first = distances.x + texelWidth(distances.x) * dot(offset, unpackHalf2x16(slopes.y));
        float last = distances.y + texelWidth(distances.y) * dot(offset, unpackHalf2x16(slopes.w));
        float distance = mix(first, last, (u - begin) / max(end - begin, 1e-20));
        uint id = texelFetch(rangeIds, range).x;
        found = begin <= u && u <= end && depth > distance && id != own;
#ifdef CUTOUTS
        if (found) found = cutoutCoversLight(id, m.position, u);
#endif
    }
    return found;
}

ListSummary summaryOf(ivec2 texel) {
    ivec2 list = listOf(texel);
    ListSummary summary = emptySummary();
    for (int range = list.x; range < list.y; ++range) {
        vec2 times = texelFetch(rangeTimes, range).xy;
        if (times.x > times.y) continue;  // empty
        ++summary.entries;
        summary.firstTime = min(summary.firstTime, times.x);
    }
    return summary;
}
