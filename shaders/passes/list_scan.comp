// Exclusive prefix sum over the counters of all cells, in three dispatches with a block of LIST_SCAN_BLOCK cells per
// work group. SCAN_STEP 0: sum of each block. 1: exclusive prefix over the blocks' sums, by one group. 2: prefix inside
// each block, on top of the block's own start. Sums saturate instead of wrapping, so that a total too large to hold is
// seen as such. Where there is no room for so many, all lists are left empty, with cursors that are no place at all.
#include "shared/frame_blocks.shared.h"

#define GROUP 256
#define PER_THREAD (LIST_SCAN_BLOCK / GROUP)

layout(local_size_x = GROUP) in;
layout(std430, binding = LIST_CURSORS_BINDING) buffer ListCursors { uint listCursors[]; };
layout(std430, binding = LIST_OFFSETS_BINDING) buffer ListOffsets { uint listOffsets[]; };
layout(std430, binding = LIST_BLOCKS_BINDING) buffer ListBlocks { uint listBlocks[]; };
uniform uint cells;
uniform uint blocks;
uniform uint multiple;  // every list has room for a multiple of so many
uniform uint room;      // for entries in all

#include "lib/work_groups.glsl"

shared uint sums[GROUP];

uint plus(uint a, uint b) {
    uint sum = a + b;
    return sum < a ? 0xffffffffu : sum;
}

uint roomFor(uint count) { return plus(count, multiple - 1u) / multiple * multiple; }

// Sum over the threads before this one (Hillis and Steele 1986); `total` over all.
uint exclusiveOverGroup(uint value, out uint total) {
    uint thread = gl_LocalInvocationID.x;
    sums[thread] = value;
    barrier();
    for (uint step = 1u; step < uint(GROUP); step *= 2u) {
        uint before = thread >= step ? sums[thread - step] : 0u;
        barrier();
        sums[thread] = plus(sums[thread], before);
        barrier();
    }
    total = sums[GROUP - 1];
    return thread > 0u ? sums[thread - 1u] : 0u;
}

void main() {
    uint thread = gl_LocalInvocationID.x, total;
#if SCAN_STEP == 1
    uint each = (blocks + uint(GROUP) - 1u) / uint(GROUP);
    uint first = min(thread * each, blocks), last = min(first + each, blocks);
    uint sum = 0u;
    for (uint i = first; i < last; ++i) sum = plus(sum, listBlocks[i]);
    uint before = exclusiveOverGroup(sum, total);
    for (uint i = first; i < last; ++i) {
        uint count = listBlocks[i];
        listBlocks[i] = before;
        before = plus(before, count);
    }
    if (thread == 0u) {
        listOffsets[cells] = total <= room ? total : 0u;
        listBlocks[blocks] = total;
    }
#else
    uint block = groupIndex();  // beyond the last one there are no cells
    uint first = min(block, blocks) * uint(LIST_SCAN_BLOCK) + thread * uint(PER_THREAD);
    uint last = min(first + uint(PER_THREAD), cells);
    uint sum = 0u, longest = 0u;
    for (uint i = first; i < last; ++i) {
        sum = plus(sum, roomFor(listCursors[i]));
        longest = max(longest, listCursors[i]);
    }
    uint before = exclusiveOverGroup(sum, total);
#if SCAN_STEP == 0
    if (thread == 0u && block < blocks) listBlocks[block] = total;
    if (longest > 0u) atomicMax(listBlocks[blocks + 1u], longest);
#else
    bool fits = listBlocks[blocks] <= room;
    if (block < blocks) before = plus(before, listBlocks[block]);
    for (uint i = first; i < last; ++i) {
        uint count = roomFor(listCursors[i]);
        listOffsets[i] = fits ? before : 0u;
        listCursors[i] = fits ? before : NO_LIST_SLOT;
        before = plus(before, count);
    }
#endif
#endif
}
