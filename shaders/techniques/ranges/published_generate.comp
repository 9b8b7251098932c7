// Generation sub-pass as published (section 4.3), one invocation a texel (the paper draws a full screen): the fragments of one triangle, sorted by depth, make a
// range each two. What the paper leaves open: fragments of equal depth keep the order in which the list has them when it is
// drawn in order (the caps, drawn last, come first; then by time); one that is left over is dropped, as are those beyond four.
#include "techniques/ranges/bindings.shared.h"
#include "techniques/ranges/published_counts.glsl"

layout(std430, binding = LINKED_HEADS_BINDING) readonly buffer FragmentHeads { uint fragmentHeads[]; };
layout(std430, binding = LINKED_FRAGMENTS_BINDING) buffer Fragments { uint fragments[]; };  // depth, time, triangle, next
layout(std430, binding = LINKED_RANGE_HEADS_BINDING) writeonly buffer RangeHeads { uint rangeHeads[]; };
layout(std430, binding = LINKED_RANGES_BINDING) writeonly buffer Ranges { uint ranges[]; };

layout(local_size_x = 64) in;
uniform uint texels;

struct Visit { float depth; float time; };

bool isCap(Visit v) { return v.time == 0.0 || v.time == 1.0; }

// Ascending distance; window depth is reversed.
bool before(Visit a, Visit b) {
    if (a.depth != b.depth) return a.depth > b.depth;
    if (isCap(a) != isCap(b)) return isCap(a);
    return a.time < b.time;
}

const Visit NO_INTERVAL = Visit(-1.0, 2.0);  // farther than any

Visit intervalAt(uint place) {
    return Visit(uintBitsToFloat(fragments[4u * place]), uintBitsToFloat(fragments[4u * place + 1u]));
}

// Puts a visit into its place among a and whatever comes behind, and hands on what has to move.
void insert(inout Visit a, inout Visit visit) {
    if (!before(visit, a)) return;
    Visit other = a;
    a = visit;
    visit = other;
}

uint addRange(Visit a, Visit b, uint id, uint next) {
    if (a.time > b.time) {
        Visit other = a;
        a = b;
        b = other;
    }
    uint place = atomicAdd(rangeCount, 1u), word = place * uint(RANGE_WORDS);
    ranges[word] = floatBitsToUint(a.time);
    ranges[word + 1u] = floatBitsToUint(b.time);
    ranges[word + 2u] = floatBitsToUint(a.depth);
    ranges[word + 3u] = floatBitsToUint(b.depth);
    ranges[word + 4u] = id;
    ranges[word + 5u] = next;
    return place;
}

void main() {
    uint texel = gl_GlobalInvocationID.x;
    if (texel >= texels) return;
    uint head = NO_ENTRY, length = 0u;
    bool odd = false;
    uint place = fragmentHeads[texel];
    while (place != NO_ENTRY) {
        uint id = fragments[4u * place + 2u];
        ++length;
        if (id != NO_TRIANGLE) {  // else taken already
            Visit first = intervalAt(place), second = NO_INTERVAL, third = NO_INTERVAL, fourth = NO_INTERVAL;
            uint count = 1u, other = fragments[4u * place + 3u];
            while (other != NO_ENTRY) {
                if (fragments[4u * other + 2u] == id) {
                    Visit visit = intervalAt(other);
                    insert(first, visit);
                    insert(second, visit);
                    insert(third, visit);
                    insert(fourth, visit);
                    fragments[4u * other + 2u] = NO_TRIANGLE;
                    ++count;
                }
                other = fragments[4u * other + 3u];
            }
            odd = odd || (count & 1u) != 0u;
            if (count >= 2u) head = addRange(first, second, id, head);
            if (count >= 4u) head = addRange(third, fourth, id, head);
        }
        place = fragments[4u * place + 3u];
    }
    rangeHeads[texel] = head;
    if (length > 0u) atomicMax(longestList, length);
    if (odd) atomicAdd(unpairedLists, 1u);
}
