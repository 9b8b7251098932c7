// From what a texel saw at each of its times to its visibility function, compressed (shared/visibility_function.
// shared.h). Done twice: once to count its nodes, and with FILL to write them.
//
// CAPACITY: at least as many as there are times.
#include "lib/cell_lists.glsl"
#include "lib/light_projection.glsl"
#include "lib/settings.glsl"
#include "shared/shutter_response.shared.h"
#include "shared/visibility_function.shared.h"
#include "techniques/deep/bindings.shared.h"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = DEEP_NODES_BINDING) writeonly buffer DeepNodes { vec2 deepNodes[]; };
layout(std430, binding = DEEP_COUNTS_BINDING) buffer DeepCounts {
    uint hits;         // times at which a texel saw something, of all texels
    uint texelsInUse;  // that saw something at any time
    uint mostNodes;    // of a texel
};
uniform sampler2DArray samples;  // some rows of the map, a layer a time
uniform uint times;
uniform float timeLength;  // u; 0: there is but one instant
uniform int firstRow;      // of the map that the samples hold
#ifdef FILL
uniform usamplerBuffer nodeOffsets;
#endif

vec2 seen[CAPACITY];  // distance, share of the exposure

// Share of the exposure that falls into the stratum of a time.
float shareOf(uint time) {
    if (frame.response == SHUTTER_BOX || timeLength == 0.0) return 1.0 / float(times);
    float begin = frame.timeBase + float(time) * timeLength, end = frame.timeBase + float(times) * timeLength;
    float all = shutterExposure(frame.response, frame.responseWidth, end) -
                shutterExposure(frame.response, frame.responseWidth, frame.timeBase);
    return (shutterExposure(frame.response, frame.responseWidth, begin + timeLength) -
            shutterExposure(frame.response, frame.responseWidth, begin)) /
           all;
}

uint collect(ivec2 place) {
    uint count = 0u;
    for (uint time = 0u; time < times; ++time) {
        float stored = texelFetch(samples, ivec3(place, time), 0).x;
        if (stored > 0.0) seen[count++] = vec2(mapDistance(stored), shareOf(time));
    }
    return count;
}

// By distance: Shell's sort, with the gaps of Ciura 2001. A surface's depths mostly rise or fall over the shutter.
void sortSeen(uint count) {
    const uint gaps[6] = uint[](132u, 57u, 23u, 10u, 4u, 1u);
    for (int g = 0; g < 6; ++g) {
        uint gap = gaps[g];
        for (uint i = gap; i < count; ++i) {
            vec2 moved = seen[i];
            uint place = i;
            for (; place >= gap && seen[place - gap].x > moved.x; place -= gap) seen[place] = seen[place - gap];
            seen[place] = moved;
        }
    }
}

float behindAll(uint count) {
    float visibility = 1.0;
    for (uint i = 0u; i < count; ++i) visibility -= seen[i].y;
    return max(visibility, 0.0);
}

uint compress(uint count, uint firstNode) {
    VisibilityWedge w = emptyVisibility(behindAll(count));
    float visibility = 1.0;
    for (uint i = 0u; i < count; ++i) {
        visibility -= seen[i].y;
        bool isLast = i + 1u == count;
        if (!isLast && seen[i + 1u].x == seen[i].x) continue;  // one jump of several times
        w = withJump(w, seen[i].x, max(visibility, w.end), setting.error, isLast);
#ifdef FILL
        uint node = firstNode + w.nodes - w.newNodes;
        if (w.newNodes > 0u) deepNodes[node] = w.new0;
        if (w.newNodes > 1u) deepNodes[node + 1u] = w.new1;
        if (w.newNodes > 2u) deepNodes[node + 2u] = w.new2;
#endif
    }
    return w.nodes;
}

void main() {
    ivec2 size = ivec2(lightView.size);
    uint index = invocationIndex();
    ivec2 place = ivec2(index % uint(size.x), index / uint(size.x));
    uint cell = uint((firstRow + place.y) * size.x + place.x);
    if (place.y >= textureSize(samples, 0).y || firstRow + place.y >= size.y) return;
#ifdef FILL
    uint firstNode = texelFetch(nodeOffsets, int(cell)).x;
    if (firstNode == texelFetch(nodeOffsets, int(cell) + 1).x) return;  // saw nothing: its times need not be read again
#endif
    uint count = collect(place);
    if (count == 0u) return;
    sortSeen(count);
#ifdef FILL
    compress(count, firstNode);
#else
    uint nodes = compress(count, 0u);
    listCursors[cell] = nodes;
    atomicAdd(hits, count);
    atomicAdd(texelsInUse, 1u);
    atomicMax(mostNodes, nodes);
#endif
}
