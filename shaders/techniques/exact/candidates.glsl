// Which cells of the candidate grid a triangle may shadow something in, during one bucket of time: what counting and filling,
// and small and large triangles, have in common. FILL: write entries; otherwise count them.
#include "lib/blocks.glsl"
#include "lib/cell_lists.glsl"
#include "techniques/exact/least_depth.glsl"
#include "shared/candidate_bounds.shared.h"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
layout(binding = LARGE_TRIANGLES_UNIT) uniform usamplerBuffer casters;  // triangles that may cast a shadow
uniform uint gridSide;   // cells along a side
uniform uint buckets;    // of the shutter
uniform uint items;      // casters times buckets

#ifdef FILL
layout(std430, binding = TECHNIQUE_STORAGE_BINDING) writeonly buffer Candidates { uint candidates[]; };
#endif

struct Footprint {
    uint caster;
    uint list;  // first list of its bucket
    EdgeSweep edge0, edge1, edge2;
    float nearest;  // depth that no point of it is nearer than
    vec2 lowBound, highBound;  // of its projection, in cells
    ivec2 low, high;           // cells [low, high)
};

vec3 viewOpen(vec3 p) { return (lightView.viewFromWorldOpen * vec4(p, 1.0)).xyz; }
vec3 viewClose(vec3 p) { return (lightView.viewFromWorldClose * vec4(p, 1.0)).xyz; }
#ifdef LIGHT_ORTHOGRAPHIC
vec3 flattened(vec3 v) { return vec3(v.xy, 1.0); }
#else
vec3 flattened(vec3 v) { return v; }
#endif

// item: caster times the number of buckets, plus the bucket.
Footprint footprintOf(uint item) {
    uint bucket = item % buckets;
    uint id = texelFetch(casters, int(item / buckets)).x;
    int first = int(id) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(trianglePositions, first), b = texelFetch(trianglePositions, first + 1),
         c = texelFetch(trianglePositions, first + 2), d = texelFetch(trianglePositions, first + 3),
         e = texelFetch(trianglePositions, first + 4);
    vec3 open0 = viewOpen(a.xyz), open1 = viewOpen(vec3(a.w, b.xy)), open2 = viewOpen(vec3(b.zw, c.x));
    vec3 close0 = viewClose(c.yzw), close1 = viewClose(d.xyz), close2 = viewClose(vec3(d.w, e.xy));
    // A little over both ends, as the receiver's bucket is found by a rounded product.
    float begin = max(float(bucket) / float(buckets) - 1e-6, 0.0);
    float end = min(float(bucket + 1u) / float(buckets) + 1e-6, 1.0);
    vec3 a0 = mix(open0, close0, begin), a1 = mix(open1, close1, begin), a2 = mix(open2, close2, begin);
    vec3 b0 = mix(open0, close0, end), b1 = mix(open1, close1, end), b2 = mix(open2, close2, end);
    Footprint f;
    bool moves = any(notEqual(a.xyz, c.yzw)) || any(notEqual(vec3(a.w, b.xy), d.xyz)) || any(notEqual(vec3(b.zw, c.x), vec3(d.w, e.xy)));
    f.caster = moves ? id | CANDIDATE_MOVES : id;
    f.list = bucket * gridSide * gridSide;
    f.nearest = min(min(min(a0.z, a1.z), min(a2.z, b0.z)), min(b1.z, b2.z));
    f.nearest -= 4e-6 * max(abs(f.nearest), max(max(max(a0.z, a1.z), max(a2.z, b0.z)), max(b1.z, b2.z)));
#ifdef LIGHT_ORTHOGRAPHIC
    SweptBounds bounds = sweptBoundsOrthographic(a0, a1, a2, b0, b1, b2);
#else
    SweptBounds bounds = sweptBoundsPerspective(a0, a1, a2, b0, b1, b2, 0.0);
#endif
    f.edge0 = edgeSweep(flattened(a1), flattened(a2), flattened(b1), flattened(b2));
    f.edge1 = edgeSweep(flattened(a2), flattened(a0), flattened(b2), flattened(b0));
    f.edge2 = edgeSweep(flattened(a0), flattened(a1), flattened(b0), flattened(b1));
    // Clamped as floats: a bound may be too large for an int.
    vec2 side = vec2(float(gridSide));
    f.lowBound = clamp((bounds.low - MAP_POSITION_SLACK) * side, vec2(-1.0), side + 1.0);
    f.highBound = clamp((bounds.high + MAP_POSITION_SLACK) * side, vec2(-1.0), side + 1.0);
    f.low = ivec2(clamp(floor(f.lowBound), vec2(0.0), side));
    f.high = ivec2(clamp(floor(f.highBound) + 1.0, vec2(0.0), side));
    return f;
}

void visitCell(Footprint f, ivec2 cell) {
    float width = 1.0 / float(gridSide);
    if (missesSquare(f.edge0, f.edge1, f.edge2, (vec2(cell) + 0.5) * width, 0.5 * width + MAP_POSITION_SLACK)) return;
    uint slot = listSlot(f.list + uint(cell.y) * gridSide + uint(cell.x));
#ifdef FILL
    uint place = candidatePlace(slot);
    candidates[place] = packCandidateBounds(f.lowBound - vec2(cell), f.highBound - vec2(cell), depthStep(f.nearest, leastDepth()));
    candidates[place + CANDIDATES_TOGETHER] = f.caster;
#endif
}
