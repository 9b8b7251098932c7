// When the light sees each interval first and last, and how many of each texel it sees at all. Unless `visible_only`,
// all of them are taken to be seen.
#include "lib/cell_lists.glsl"
#include "lib/cutouts.glsl"
#include "lib/settings.glsl"
#include "techniques/intervals/collected.glsl"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = VISIBLE_TIMES_BINDING) writeonly buffer VisibleTimes { vec2 visibleTimes[]; };

uint asking;  // place of the interval that others may hide

// Of the others, what is cut out by its alpha hides nothing.
MapInterval loadInterval(uint place) {
    MapInterval i = collectedInterval(place);
#ifdef CUTOUTS
    if (place != asking && isCutOut(i.id)) i = noInterval();
#endif
    return i;
}
float loadBegin(uint place) { return intervalTimes[place].x; }
void storeInterval(uint place, MapInterval i) {}

#include "shared/interval_list.shared.h"

void main() {
    uint place = invocationIndex();
    if (!isInterval(place)) return;
    asking = place;
    uint texel = texelOfInterval(place);
    MapInterval i = collectedInterval(place);
    if (setting.visible_only) i = visiblePart(listOffsets[texel], listOffsets[texel + 1u], place);
    visibleTimes[place] = vec2(i.begin, i.end);
    if (i.begin < i.end) listSlot(texel);
}
