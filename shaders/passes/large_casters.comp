// The triangles and buckets of the queue, one work group at a time for each; the group's invocations share the cells.
#include "lib/candidate_cells.glsl"

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
layout(std430, binding = TECHNIQUE_STORAGE_BINDING + 1) readonly buffer Queue {
    uint queued;
    uint queue[];
};

void main() {
    for (uint place = groupIndex(); place < queued; place += groupCount()) {
        SweptCaster c = sweptCasterOf(queue[place]);
        ivec2 extent = max(c.high - c.low, ivec2(0));
        for (int i = int(gl_LocalInvocationID.x); i < extent.x * extent.y; i += 64)
            addToCell(c, c.low + ivec2(i % extent.x, i / extent.x));
    }
}
