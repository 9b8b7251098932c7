// As published: inserts the intervals of each list, in the order in which triangles are drawn, into one of at most
// `capacity`, where they lie. Done for some intervals of each list at a time, from number `from` up to `to`.
#include "shared/map_interval.shared.h"
#include "techniques/intervals/bindings.shared.h"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = LIST_OFFSETS_BINDING) readonly buffer ListOffsets { uint listOffsets[]; };
layout(std430, binding = ARRANGED_TIMES_BINDING) buffer ArrangedTimes { vec2 arrangedTimes[]; };
layout(std430, binding = ARRANGED_DEPTHS_BINDING) buffer ArrangedDepths { vec2 arrangedDepths[]; };
layout(std430, binding = ARRANGED_IDS_BINDING) buffer ArrangedIds { uint arrangedIds[]; };
layout(std430, binding = INTERVAL_ERRORS_BINDING) buffer IntervalErrors { float intervalErrors[]; };
uniform uint texels;
uniform uint capacity;
uniform uint from;
uniform uint to;

MapInterval loadInterval(uint place) {
    vec2 times = arrangedTimes[place], depths = arrangedDepths[place];
    return MapInterval(times.x, times.y, depths.x, depths.y, arrangedIds[place]);
}

float loadBegin(uint place) { return arrangedTimes[place].x; }

void storeInterval(uint place, MapInterval i) {
    arrangedTimes[place] = vec2(i.begin, i.end);
    arrangedDepths[place] = vec2(i.depthBegin, i.depthEnd);
    arrangedIds[place] = i.id;
}

#include "shared/interval_list.shared.h"

void main() {
    uint texel = invocationIndex();
    if (texel >= texels) return;
    uint first = listOffsets[texel], last = listOffsets[texel + 1u];
    float error = from > 0u ? intervalErrors[texel] : 0.0;
    if (first + from < last) error += compressIntervals(first, first + from, min(last, first + to), capacity);
    intervalErrors[texel] = error;
}
