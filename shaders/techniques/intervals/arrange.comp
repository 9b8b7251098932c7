// Puts each interval at its place in order. AS_PUBLISHED: all of them, into lists of the same places, by time or, with
// `as_drawn`, in the order in which triangles are drawn. Else what is seen of each, into lists of their own.
#include "techniques/intervals/collected.glsl"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = ARRANGED_TIMES_BINDING) writeonly buffer ArrangedTimes { vec2 arrangedTimes[]; };
layout(std430, binding = ARRANGED_DEPTHS_BINDING) writeonly buffer ArrangedDepths { vec2 arrangedDepths[]; };
layout(std430, binding = ARRANGED_IDS_BINDING) writeonly buffer ArrangedIds { uint arrangedIds[]; };
#ifdef AS_PUBLISHED
uniform uint asDrawn;

MapInterval loadInterval(uint place) { return collectedInterval(place); }
float loadBegin(uint place) { return intervalTimes[place].x; }
#else
layout(std430, binding = ARRANGED_OFFSETS_BINDING) readonly buffer ArrangedOffsets { uint arrangedOffsets[]; };
layout(std430, binding = VISIBLE_TIMES_BINDING) readonly buffer VisibleTimes { vec2 visibleTimes[]; };

MapInterval loadInterval(uint place) {
    vec2 times = visibleTimes[place];
    return clippedTo(collectedInterval(place), times.x, times.y);
}
float loadBegin(uint place) { return visibleTimes[place].x; }
#endif
void storeInterval(uint place, MapInterval i) {}

#include "shared/interval_list.shared.h"

void main() {
    uint place = invocationIndex();
    if (!isInterval(place)) return;
    MapInterval i = loadInterval(place);
    if (i.begin >= i.end) return;
    uint texel = texelOfInterval(place), first = listOffsets[texel];
    uint last = listOffsets[texel + 1u];
#ifdef AS_PUBLISHED
    uint target = first + (asDrawn != 0u ? rankAsDrawn(first, last, place) : rankByTime(first, last, place));
#else
    uint target = arrangedOffsets[texel] + rankByTime(first, last, place);
#endif
    if (target >= uint(arrangedTimes.length())) return;
    arrangedTimes[target] = vec2(i.begin, i.end);
    arrangedDepths[target] = vec2(i.depthBegin, i.depthEnd);
    arrangedIds[target] = i.id;
}
