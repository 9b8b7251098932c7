// The lists of intervals, sorted by when they begin; what stands for no interval begins after the shutter's close.
#include "lib/light_cutouts.glsl"
#include "lib/only_if.glsl"
#include "lib/texel_lists.glsl"
#include "shared/map_interval.shared.h"

uniform usamplerBuffer intervalOffsets;
uniform samplerBuffer intervalTimes;
uniform samplerBuffer intervalDepths;
uniform usamplerBuffer intervalIds;

// Is a triangle other than the receiver's own nearer to the light than `depth`, in this texel at this time, and does it
// cover `place` of the map? (Palmér 2011, section 3.2: of the intervals that overlap the time, any with a lower depth.)
bool nearerThan(ivec2 texel, vec2 place, float depth, uint own, float time) {
    ivec2 span = listSpan(intervalOffsets, listNumber(texel));
    bool nearer = false;
    for (int i = span.x; i < span.y && !nearer; ++i) {
        vec2 times = texelFetch(intervalTimes, i).xy;
        if (times.x > time) break;
        ONLY_IF(time <= times.y) {
            vec2 depths = texelFetch(intervalDepths, i).xy;
            bool before = mix(depths.x, depths.y, (time - times.x) / max(times.y - times.x, 1e-30)) < depth;
            ONLY_IF(before) {
                uint id = texelFetch(intervalIds, i).x;
                nearer = id != own && (id == NO_INTERVAL_ID || cutoutCoversLight(id, place, time));
            }
        }
    }
    return nearer;
}

ListSummary summaryOf(ivec2 texel) {
    ivec2 span = listSpan(intervalOffsets, listNumber(texel));
    ListSummary list = emptySummary();
    for (int i = span.x; i < span.y; ++i) {
        float begin = texelFetch(intervalTimes, i).x;
        if (begin > 1.0) break;
        ++list.entries;
        list.firstTime = min(list.firstTime, begin);
    }
    return list;
}
