// Lists of exact size, an array per field.
uniform usamplerBuffer tupleOffsets;
uniform samplerBuffer tupleTimes;
uniform samplerBuffer tupleDepths;
uniform usamplerBuffer tupleIds;
#ifdef COVERAGE_MAP
#include "techniques/temporal/coverage.glsl"
#endif

// Is a triangle other than the receiver's own nearer to the light than `depth`, in this texel at this time?
bool nearerThan(float depth, ivec2 texel, uint own, float time) {
#ifdef COVERAGE_MAP
    if (depth > coverageDistance(texel)) return true;
#endif
    int cell = texel.y * int(frame.mapSize) + texel.x;
    int last = int(texelFetch(tupleOffsets, cell + 1).x);
    bool nearer = false;
    for (int i = int(texelFetch(tupleOffsets, cell).x); i < last && !nearer; ++i) {
        vec2 times = texelFetch(tupleTimes, i).xy;
        ONLY_IF(time >= times.x && time <= times.y) {
            vec2 depths = texelFetch(tupleDepths, i).xy;
            bool before = mix(depths.x, depths.y, (time - times.x) / max(times.y - times.x, 1e-30)) < depth;
            ONLY_IF(before) nearer = texelFetch(tupleIds, i).x != own;
        }
    }
    return nearer;
}

ListSummary summaryOf(ivec2 texel) {
    int cell = texel.y * int(frame.mapSize) + texel.x;
    int first = int(texelFetch(tupleOffsets, cell).x), last = int(texelFetch(tupleOffsets, cell + 1).x);
    ListSummary list = ListSummary(last - first, 2.0);
    for (int i = first; i < last; ++i) list.firstTime = min(list.firstTime, texelFetch(tupleTimes, i).x);
    return list;
}
