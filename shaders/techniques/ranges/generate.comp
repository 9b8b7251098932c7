// Turns each texel's fragments into ranges, in place: sorted by triangle and time, two in a row are the beginning and
// the end of one coverage interval. (Hong and Oh 2019 sort by depth, which pairs wrongly where a triangle covers the
// texel twice.) The order depends on the fragments alone, not on their order in the list before. A triangle with an
// unpaired fragment has a prism that is not closed: the near plane cut a part of it off, or the rasteriser was not
// consistent. The fragment then stands for an interval that lasts to the shutter's close, or from its open, by which
// cap is missing. Each list has room for an even number, so that ranges begin at even places; there is always room for
// one such interval, not for all of several.
#include "techniques/ranges/fragment_lists.glsl"
#include "lib/cell_lists.glsl"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = LIST_OFFSETS_BINDING) readonly buffer ListOffsets { uint listOffsets[]; };
layout(std430, binding = RANGES_COUNTS_BINDING) buffer RangeCounts {
    uint unpairedLists;  // texels with a triangle that left an odd number of fragments there
    uint longestList;    // fragments
    uint sparePlaces;    // of lists whose number of fragments is odd
    uint emptyRanges;
};
uniform uint texels;

bool before(uint idA, float timeA, float distanceA, uint idB, float timeB, float distanceB) {
    if (idA != idB) return idA < idB;
    if (timeA != timeB) return timeA < timeB;
    return distanceA < distanceB;
}

// Is the list sorted already, and does every triangle have an even number of fragments in it? Devices draw triangles
// mostly in order, so that most lists need no more than this.
void inspect(uint first, uint last, out bool sorted, out bool even) {
    sorted = true;
    even = ((last - first) & 1u) == 0u;
    uint lastId = 0u;
    float lastTime = -1.0, lastDistance = 0.0;
    for (uint i = first; i < last; ++i) {
        uint id = fragmentIds[i];
        float time = fragmentTimes[i], distance = fragmentDistances[i];
        sorted = sorted && !before(id, time, distance, lastId, lastTime, lastDistance);
        even = even && (((i - first) & 1u) == 0u || id == lastId);
        lastId = id;
        lastTime = time;
        lastDistance = distance;
    }
}

// Shell's sort with the gaps of Ciura 2001: little work where the order is nearly right, as devices leave it, and not
// quadratic where it is not.
const uint gaps[8] = uint[8](701u, 301u, 132u, 57u, 23u, 10u, 4u, 1u);

void sortFragments(uint first, uint last) {
    for (uint g = 0u; g < 8u; ++g) {
        uint gap = gaps[g];
        for (uint i = first + gap; i < last; ++i) {
            uint id = fragmentIds[i], place = i;
            float time = fragmentTimes[i], distance = fragmentDistances[i];
            uint otherId = fragmentIds[place - gap];
            float otherTime = fragmentTimes[place - gap], otherDistance = fragmentDistances[place - gap];
            if (!before(id, time, distance, otherId, otherTime, otherDistance)) continue;
            uvec2 slope = fragmentSlopes[i];
            do {
                fragmentIds[place] = otherId;
                fragmentTimes[place] = otherTime;
                fragmentDistances[place] = otherDistance;
                fragmentSlopes[place] = fragmentSlopes[place - gap];
                place -= gap;
                if (place < first + gap) break;
                otherId = fragmentIds[place - gap];
                otherTime = fragmentTimes[place - gap];
                otherDistance = fragmentDistances[place - gap];
            } while (before(id, time, distance, otherId, otherTime, otherDistance));
            fragmentIds[place] = id;
            fragmentTimes[place] = time;
            fragmentDistances[place] = distance;
            fragmentSlopes[place] = slope;
        }
    }
}

void putRange(uint place, uint id, vec2 times, vec2 distances, uvec4 slopes) {
    for (uint i = 0u; i < 2u; ++i) {
        fragmentIds[place + i] = id;
        fragmentTimes[place + i] = times[i];
        fragmentDistances[place + i] = distances[i];
        fragmentSlopes[place + i] = i == 0u ? slopes.xy : slopes.zw;
    }
}

void pairUnpairedList(uint first, uint last, uint room) {
    uint to = first, loneId = 0u;
    bool lone = false;
    vec2 loneTimes = vec2(0.0), loneDistance = vec2(0.0);
    for (uint begin = first; begin < last;) {
        uint id = fragmentIds[begin], end = begin + 1u;
        while (end < last && fragmentIds[end] == id) ++end;
        uint pairs = (end - begin) / 2u, from = begin;
        if (((end - begin) & 1u) != 0u) {
            bool opens = fragmentTimes[begin] == 0.0;  // the open cap is there: then an end is missing
            uint alone = opens ? end - 1u : begin;
            lone = true;
            loneId = id;
            loneTimes = opens ? vec2(fragmentTimes[alone], 1.0) : vec2(0.0, fragmentTimes[alone]);
            loneDistance = vec2(fragmentDistances[alone]);
            from = opens ? begin : begin + 1u;
        }
        for (uint pair = 0u; pair < pairs; ++pair) {
            uint i = from + 2u * pair;
            putRange(to, id, vec2(fragmentTimes[i], fragmentTimes[i + 1u]),
                     vec2(fragmentDistances[i], fragmentDistances[i + 1u]),
                     uvec4(fragmentSlopes[i], fragmentSlopes[i + 1u]));
            to += 2u;
        }
        begin = end;
    }
    if (lone && to + 1u < room) {
        putRange(to, loneId, loneTimes, loneDistance, uvec4(0u));
        to += 2u;
    }
    for (; to < room; to += 2u) {
        putRange(to, 0u, vec2(2.0, -1.0), vec2(0.0), uvec4(0u));  // holds no time
        atomicAdd(emptyRanges, 1u);
    }
}

void main() {
    uint texel = invocationIndex();
    if (texel >= texels) return;
    uint first = listOffsets[texel], last = listCursors[texel];
    if (first == last || last >= NO_LIST_SLOT) return;
    if (last - first > longestList) atomicMax(longestList, last - first);
    bool sorted, even;
    inspect(first, last, sorted, even);
    if (!sorted) {
        sortFragments(first, last);
        inspect(first, last, sorted, even);
    }
    if (even) return;  // the list of fragments is the list of ranges
    atomicAdd(unpairedLists, 1u);
    if (((last - first) & 1u) != 0u) atomicAdd(sparePlaces, 1u);
    pairUnpairedList(first, last, listOffsets[texel + 1u]);
}
