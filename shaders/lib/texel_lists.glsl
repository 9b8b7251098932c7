// Lists of time intervals, one list per texel of the shadow map: what lookups and views of every such technique share.
#include "lib/light_map.glsl"

int listNumber(ivec2 texel) { return texel.y * int(frame.mapWidth) + texel.x; }

// First entry of a list and the one behind its last. `offsets`: where each list begins, and behind the last where it
// ends.
ivec2 listSpan(usamplerBuffer offsets, int list) {
    return ivec2(texelFetch(offsets, list).x, texelFetch(offsets, list + 1).x);
}

// What a view shows of one list.
struct ListSummary {
    int entries;
    float firstTime;  // u at which the first interval begins; 2 where there is none
};

ListSummary emptySummary() { return ListSummary(0, 2.0); }
