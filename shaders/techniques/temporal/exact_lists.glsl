// The repaired form's lists, of exact size, with an array per field; included by lists.glsl.
uniform usamplerBuffer tupleOffsets;
uniform samplerBuffer tupleTimes;
uniform samplerBuffer tupleDepths;
uniform usamplerBuffer tupleIds;
#ifdef COVERAGE_MAP
#include "techniques/temporal/coverage.glsl"
#endif

// Is a triangle other than the receiver's own nearer to the light than `depth`, in this texel at this time?
bool nearerThan(MapPoint m, float depth, ivec2 texel, uint own, float time) {
#ifdef COVERAGE_MAP
    if (depth > coverageDistance(texel)) return true;
#endif
    ivec2 span = listSpan(tupleOffsets, listNumber(texel));
    bool nearer = false;
    for (int i = span.x; i < span.y && !nearer; ++i) {
        vec2 times = texelFetch(tupleTimes, i).xy;
        ONLY_IF(time >= times.x && time <= times.y) {
            vec2 depths = texelFetch(tupleDepths, i).xy;
            bool before = mix(depths.x, depths.y, (time - times.x) / max(times.y - times.x, 1e-30)) < depth;
            ONLY_IF(before) {
                uint id = texelFetch(tupleIds, i).x;
                nearer = id != own && cutoutCoversLight(id, m.position, time);
            }
        }
    }
    return nearer;
}

ListSummary summaryOf(ivec2 texel) {
    ivec2 span = listSpan(tupleOffsets, listNumber(texel));
    ListSummary list = emptySummary();
    list.entries = span.y - span.x;
    for (int i = span.x; i < span.y; ++i) list.firstTime = min(list.firstTime, texelFetch(tupleTimes, i).x);
    return list;
}
