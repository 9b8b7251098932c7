// Where a kept answer may be another by now: another triangle is seen than what stands still, or something that moves may come
// between it and the light. Everything else is discarded; what is left lets the technique's own lookup through, by the depth test.
#include "lib/blocks.glsl"

layout(binding = SAMPLE_IDS_UNIT) uniform usampler2DArray sampleIds;
layout(binding = KEPT_IDS_UNIT) uniform usampler2DArray keptIds;
layout(binding = KEPT_CELLS_UNIT) uniform usampler2DArray keptCells;
layout(binding = REACHED_UNIT) uniform usampler2D reachedCells;
layout(location = 0) uniform uint stratum;

void main() {
    ivec3 at = ivec3(gl_FragCoord.xy, stratum);
    uint cell = texelFetch(keptCells, at, 0).x;
    ivec2 place = cell == NO_CELL ? ivec2(0) : ivec2(cell % REACHED_SIDE, cell / REACHED_SIDE);
    bool reached = cell != NO_CELL && texelFetch(reachedCells, place, 0).x != 0u;
    if (!reached && texelFetch(sampleIds, at, 0).x == texelFetch(keptIds, at, 0).x) discard;
}
