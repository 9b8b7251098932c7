// Which cells of the candidate grid a triangle may shadow something in, during one bucket of time: what counting and
// filling, and small and large triangles, have in common. FILL: write entries; otherwise count them.
#include "lib/blocks.glsl"
#include "lib/cell_lists.glsl"
#include "lib/triangle_texels.glsl"
#include "lib/least_depth.glsl"
#include "shared/candidate_bounds.shared.h"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
layout(binding = LARGE_TRIANGLES_UNIT) uniform usamplerBuffer casters;  // triangles that may cast a shadow
uniform uint gridSide;                                                  // cells along a side
uniform uint buckets;                                                   // of the shutter
uniform uint items;                                                     // casters times buckets

#ifdef FILL
layout(std430, binding = TECHNIQUE_STORAGE_BINDING) writeonly buffer Candidates { uint candidates[]; };
#endif

// A caster during one bucket of time, as the light sees it.
struct SweptCaster {
    uint caster;
    uint list;  // first list of its bucket
    EdgeSweep edge0, edge1, edge2;
    float nearest;             // depth that no point of it is nearer than
    vec2 lowBound, highBound;  // of its projection, in cells
    ivec2 low, high;           // cells [low, high)
    float slack;               // how far its projection may be from what the edges say, in map widths
};

#ifdef LIGHT_ORTHOGRAPHIC
vec3 flattened(vec3 v) { return vec3(v.xy, 1.0); }

// How far a moving vertex is at most from the line between its places in the map at both ends, where a sun turns: its
// path there is a parabola.
float bend(vec3 open, vec3 close) {
    mat3 turn = mat3(lightView.viewFromWorldClose) - mat3(lightView.viewFromWorldOpen);
    vec2 off = abs((turn * (close - open)).xy);
    return 0.25 * max(off.x, off.y);
}
#else
vec3 flattened(vec3 v) { return v; }
#endif

// item: caster times the number of buckets, plus the bucket.
SweptCaster sweptCasterOf(uint item) {
    uint bucket = item % buckets;
    uint id = texelFetch(casters, int(item / buckets)).x;
    VertexMotion world = fetchMotion(trianglePositions, id, true);
    VertexMotion v = inView(world, lightView.viewFromWorldOpen, lightView.viewFromWorldClose);
    // A little over both ends, as the receiver's bucket is found by a rounded product.
    float begin = max(float(bucket) / float(buckets) - 1e-6, 0.0);
    float end = min(float(bucket + 1u) / float(buckets) + 1e-6, 1.0);
    vec3 a0 = mix(v.open0, v.close0, begin), a1 = mix(v.open1, v.close1, begin), a2 = mix(v.open2, v.close2, begin);
    vec3 b0 = mix(v.open0, v.close0, end), b1 = mix(v.open1, v.close1, end), b2 = mix(v.open2, v.close2, end);
    SweptCaster c;
    bool moves = any(notEqual(world.open0, world.close0)) || any(notEqual(world.open1, world.close1)) ||
                 any(notEqual(world.open2, world.close2));
    c.caster = moves ? id | CANDIDATE_MOVES : id;
    c.list = bucket * gridSide * gridSide;
    c.nearest = min(min(min(a0.z, a1.z), min(a2.z, b0.z)), min(b1.z, b2.z));
    c.nearest -= 4e-6 * max(abs(c.nearest), max(max(max(a0.z, a1.z), max(a2.z, b0.z)), max(b1.z, b2.z)));
#ifdef LIGHT_ORTHOGRAPHIC
    SweptBounds bounds = sweptBoundsOrthographic(a0, a1, a2, b0, b1, b2);
#else
    SweptBounds bounds = sweptBoundsPerspective(a0, a1, a2, b0, b1, b2, 0.0);
#endif
    c.edge0 = edgeSweep(flattened(a1), flattened(a2), flattened(b1), flattened(b2));
    c.edge1 = edgeSweep(flattened(a2), flattened(a0), flattened(b2), flattened(b0));
    c.edge2 = edgeSweep(flattened(a0), flattened(a1), flattened(b0), flattened(b1));
    c.slack = MAP_POSITION_SLACK;
#ifdef LIGHT_ORTHOGRAPHIC
    if (moves)
        c.slack += max(bend(world.open0, world.close0),
                       max(bend(world.open1, world.close1), bend(world.open2, world.close2)));
#endif
    // Clamped as floats: a bound may be too large for an int.
    vec2 side = vec2(float(gridSide));
    c.lowBound = clamp((bounds.low - c.slack) * side, vec2(-1.0), side + 1.0);
    c.highBound = clamp((bounds.high + c.slack) * side, vec2(-1.0), side + 1.0);
    c.low = ivec2(clamp(floor(c.lowBound), vec2(0.0), side));
    c.high = ivec2(clamp(floor(c.highBound) + 1.0, vec2(0.0), side));
    return c;
}

void addToCell(SweptCaster c, ivec2 cell) {
    float width = 1.0 / float(gridSide);
    vec2 centre = (vec2(cell) + 0.5) * width;
    if (missesSquare(c.edge0, c.edge1, c.edge2, centre, 0.5 * width + c.slack)) return;
    uint slot = listSlot(c.list + uint(cell.y) * gridSide + uint(cell.x));
#ifdef FILL
    if (slot >= uint(candidates.length()) / 2u) return;
    uint place = candidatePlace(slot);
    uint nearestStep = depthStep(c.nearest, leastDepth());
    candidates[place] = packCandidateBounds(c.lowBound - vec2(cell), c.highBound - vec2(cell), nearestStep);
    candidates[place + CANDIDATES_TOGETHER] = c.caster;
#endif
}
