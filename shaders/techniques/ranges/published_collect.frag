// Collection sub-pass as published (Hong and Oh 2019, section 4.2): a linked list of fragments per texel, in one buffer
// whose entries are allocated by a counter.
#include "lib/blocks.glsl"
#include "techniques/ranges/bindings.shared.h"
#include "techniques/ranges/published_counts.glsl"

layout(std430, binding = LINKED_HEADS_BINDING) buffer FragmentHeads { uint fragmentHeads[]; };
layout(std430, binding = LINKED_FRAGMENTS_BINDING) writeonly buffer Fragments { uvec4 fragments[]; };
uniform uint capacity;

in float prismTime;
flat in uint prismId;

void main() {
    uint place = atomicAdd(fragmentCount, 1u);
    if (place >= capacity) return;  // counted; the pass is drawn again with more room
    uint texel = uint(gl_FragCoord.y) * frame.mapWidth + uint(gl_FragCoord.x);
    uint next = atomicExchange(fragmentHeads[texel], place);
    fragments[place] = uvec4(floatBitsToUint(gl_FragCoord.z), floatBitsToUint(prismTime), prismId, next);
}
