// The prism of Hong and Oh 2017: the triangle at t = 0, the triangle at t = 1 and, between them, each side in two flat
// triangles (the paper says only that it is triangulated). The fragments that a rasteriser would make of its eight
// triangles at this texel's centre are computed here at once, with what it would interpolate: time, with perspective,
// and NDC depth. Homogeneous edge functions clip at the near plane as a rasteriser does, and such a prism is open.
#include "lib/covering_triangle.glsl"

struct PrismFragment {
    float time;
    float depth;  // NDC depth, reversed: greater is nearer
};

// The prism at this texel: its fragments first and last in time, and the nearest.
struct PrismHits {
    int count;
    PrismFragment first, last, nearest;
};

PrismHits noHits() { return PrismHits(0, PrismFragment(2.0, 0.0), PrismFragment(-1.0, 0.0), PrismFragment(0.0, -1.0)); }

void addFace(inout PrismHits hits, vec3 a, vec3 b, vec3 c, vec3 times) {
    vec2 centre = texelCentre();
    precise vec3 e = edgeFunctions(seenFrom(centre, a), seenFrom(centre, b), seenFrom(centre, c));
    float sum = e.x + e.y + e.z;
    bool inside = min(min(e.x, e.y), e.z) >= 0.0 && sum > 0.0 || max(max(e.x, e.y), e.z) <= 0.0 && sum < 0.0;
    if (!inside) return;
    float distance = dot(e, vec3(a.z, b.z, c.z)) / sum;
#ifdef LIGHT_ORTHOGRAPHIC
    if (distance < 0.0 || distance > lightView.farDistance) return;
#else
    if (!(distance >= lightView.nearDistance)) return;
#endif
    // By differences, so that what is the same at all three vertices stays the same to the last bit.
    float time = times.x + (e.y * (times.y - times.x) + e.z * (times.z - times.x)) / sum;
    PrismFragment f = PrismFragment(time, ndcDepth(distance));
    hits.count++;
    if (f.time < hits.first.time) hits.first = f;
    if (f.time > hits.last.time) hits.last = f;
    if (f.depth > hits.nearest.depth) hits.nearest = f;
}

void addSide(inout PrismHits hits, vec3 p, vec3 q, vec3 movedP, vec3 movedQ) {
    addFace(hits, p, q, movedQ, vec3(0.0, 0.0, 1.0));
    addFace(hits, p, movedQ, movedP, vec3(0.0, 1.0, 1.0));
}

void addCaps(inout PrismHits hits) {
    addFace(hits, open0, open1, open2, vec3(0.0));
    addFace(hits, close0, close1, close2, vec3(1.0));
}

PrismHits prismHits() {
    PrismHits hits = noHits();
    addCaps(hits);
    addSide(hits, open0, open1, close0, close1);
    addSide(hits, open1, open2, close1, close2);
    addSide(hits, open2, open0, close2, close0);
    return hits;
}
