// Generation sub-pass as published (Hong and Oh 2019, section 4.3), one invocation per texel (the paper draws a full
// screen): the fragments of one triangle, sorted by depth, make a range of every two. Chosen here, since the paper
// leaves it open: fragments of equal depth keep the order in which the list has them when it is drawn in order (the
// caps, drawn last, come first; then by time); an unpaired one is dropped, as are those beyond four.
#include "shared/linked_intervals.shared.h"
#include "techniques/ranges/bindings.shared.h"
#include "techniques/ranges/published_counts.glsl"

layout(std430, binding = LINKED_HEADS_BINDING) readonly buffer FragmentHeads { uint fragmentHeads[]; };
// Four words each: depth, time, triangle, next.
layout(std430, binding = LINKED_FRAGMENTS_BINDING) buffer Fragments { uint fragments[]; };
layout(std430, binding = LINKED_RANGE_HEADS_BINDING) writeonly buffer RangeHeads { uint rangeHeads[]; };
layout(std430, binding = LINKED_RANGES_BINDING) writeonly buffer Ranges { uint ranges[]; };

layout(local_size_x = 64) in;
#include "lib/work_groups.glsl"
uniform uint texels;

struct PrismFragment {
    float depth;  // NDC depth, reversed: greater is nearer
    float time;
};

// Interpolated, and so rounded.
bool isCap(PrismFragment f) { return min(f.time, 1.0 - f.time) < 1e-6; }

// Ascending distance.
bool before(PrismFragment a, PrismFragment b) {
    if (a.depth != b.depth) return a.depth > b.depth;
    if (isCap(a) != isCap(b)) return isCap(a);
    return a.time < b.time;
}

const PrismFragment NO_FRAGMENT = PrismFragment(-1.0, 2.0);  // farther than any

PrismFragment fragmentAt(uint place) {
    return PrismFragment(uintBitsToFloat(fragments[4u * place]), uintBitsToFloat(fragments[4u * place + 1u]));
}

// Inserts a fragment at a if it comes before, and returns in `fragment` the one that has to move on.
void insert(inout PrismFragment a, inout PrismFragment fragment) {
    if (!before(fragment, a)) return;
    PrismFragment other = a;
    a = fragment;
    fragment = other;
}

uint addRange(PrismFragment a, PrismFragment b, uint id, uint next) {
    if (a.time > b.time) {
        PrismFragment other = a;
        a = b;
        b = other;
    }
    uint place = atomicAdd(rangeCount, 1u), word = place * uint(LINKED_INTERVAL_WORDS);
    ranges[word] = floatBitsToUint(a.time);
    ranges[word + 1u] = floatBitsToUint(b.time);
    ranges[word + 2u] = floatBitsToUint(a.depth);
    ranges[word + 3u] = floatBitsToUint(b.depth);
    ranges[word + 4u] = id;
    ranges[word + 5u] = next;
    return place;
}

void main() {
    uint texel = invocationIndex();
    if (texel >= texels) return;
    uint head = NO_INTERVAL, length = 0u;
    bool odd = false;
    uint place = fragmentHeads[texel];
    while (place != NO_INTERVAL) {
        uint id = fragments[4u * place + 2u];
        ++length;
        if (id != NO_TRIANGLE) {  // else taken already
            PrismFragment first = fragmentAt(place), second = NO_FRAGMENT, third = NO_FRAGMENT, fourth = NO_FRAGMENT;
            uint count = 1u, other = fragments[4u * place + 3u];
            while (other != NO_INTERVAL) {
                if (fragments[4u * other + 2u] == id) {
                    PrismFragment fragment = fragmentAt(other);
                    insert(first, fragment);
                    insert(second, fragment);
                    insert(third, fragment);
                    insert(fourth, fragment);
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
