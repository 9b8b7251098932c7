// One invocation per triangle and bucket goes through the cells that the triangle may overlap; triangles that overlap
// very many are put in a queue for large_casters.comp.
#include "lib/candidate_cells.glsl"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = TECHNIQUE_STORAGE_BINDING + 1) buffer Queue {
    uint queued;
    uint queue[];
};
uniform uint maxWalk;  // cells

void main() {
    uint item = invocationIndex();
    if (item >= items) return;
    SweptCaster c = sweptCasterOf(item);
    ivec2 extent = max(c.high - c.low, ivec2(0));
    bool alone = uint(extent.x * extent.y) <= maxWalk;
#ifndef FILL
    if (!alone) queue[atomicAdd(queued, 1u)] = item;
#endif
    if (!alone) c.high = c.low;
    for (int y = c.low.y; y < c.high.y; ++y)
        for (int x = c.low.x; x < c.high.x; ++x) addToCell(c, ivec2(x, y));
}
