// The lists of intervals as they were collected, and whose list an interval is in.
#include "shared/map_interval.shared.h"
#include "techniques/intervals/bindings.shared.h"

layout(std430, binding = LIST_OFFSETS_BINDING) readonly buffer ListOffsets { uint listOffsets[]; };
layout(std430, binding = INTERVAL_TIMES_BINDING) readonly buffer IntervalTimes { vec2 intervalTimes[]; };
layout(std430, binding = INTERVAL_DEPTHS_BINDING) readonly buffer IntervalDepths { vec2 intervalDepths[]; };
layout(std430, binding = INTERVAL_IDS_BINDING) readonly buffer IntervalIds { uint intervalIds[]; };
uniform uint texels;
uniform uint intervals;  // at most

bool isInterval(uint place) { return place < min(intervals, listOffsets[texels]); }

MapInterval collectedInterval(uint place) {
    vec2 times = intervalTimes[place], depths = intervalDepths[place];
    return MapInterval(times.x, times.y, depths.x, depths.y, intervalIds[place]);
}

uint texelOfInterval(uint place) {
    uint low = 0u, high = texels;  // listOffsets[low] <= place < listOffsets[high]
    while (high - low > 1u) {
        uint middle = (low + high) >> 1;
        if (listOffsets[middle] <= place)
            low = middle;
        else
            high = middle;
    }
    return low;
}
