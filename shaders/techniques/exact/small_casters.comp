// One invocation per triangle and bucket walks over the cells that the triangle may touch; triangles that touch very many are
// put in a queue for large_casters.comp.
#include "techniques/exact/candidates.glsl"

layout(local_size_x = 64) in;
layout(std430, binding = TECHNIQUE_STORAGE_BINDING + 1) buffer Queue {
    uint queued;
    uint queue[];
};
uniform uint maxWalk;  // cells

void main() {
    uint item = gl_GlobalInvocationID.x;
    if (item >= items) return;
    Footprint f = footprintOf(item);
    ivec2 extent = max(f.high - f.low, ivec2(0));
    bool alone = uint(extent.x * extent.y) <= maxWalk;
#ifndef FILL
    if (!alone) queue[atomicAdd(queued, 1u)] = item;
#endif
    if (!alone) f.high = f.low;
    for (int y = f.low.y; y < f.high.y; ++y)
        for (int x = f.low.x; x < f.high.x; ++x) visitCell(f, ivec2(x, y));
}
