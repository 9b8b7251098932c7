// When a position begins or ceases to see a moving triangle, and when two triangles change their order in depth.
//
// CAMERA_TURNS: the view does, and the polynomials are of higher degree.
#include "lib/only_if.glsl"
#include "lib/seen_candidates.glsl"

// The ray through a place of the image, in view coordinates.
vec3 rayAt(vec2 place, float u) {
#ifdef CAMERA_TURNS
    return mix((cameraView.raysOpen * vec4(place, 1.0, 0.0)).xyz, (cameraView.raysClose * vec4(place, 1.0, 0.0)).xyz,
               u);
#else
    return vec3(place, 1.0);
#endif
}

float leastDepthOf(ViewPath v) {
    return min(min(min(v.open0.z, v.open1.z), min(v.open2.z, v.close0.z)), min(v.close1.z, v.close2.z));
}

float mostDepthOf(ViewPath v) {
    return max(max(max(v.open0.z, v.open1.z), max(v.open2.z, v.close0.z)), max(v.close1.z, v.close2.z));
}

bool reachesNearPlane(ViewPath v) { return leastDepthOf(v) < 1.01 * cameraView.nearDistance; }

// Bounds of the depths that a ray sees of it: those of its vertices, if the ray does not turn.
vec2 depthsOf(ViewPath v) {
#ifdef CAMERA_TURNS
    return vec2(0.0, 3e38);
#else
    return vec2(leastDepthOf(v), mostDepthOf(v));
#endif
}

vec3 leastAbove(vec3 times, float u) { return mix(vec3(1.0), times, greaterThan(times, vec3(u))); }
vec4 leastAbove(vec4 times, float u) { return mix(vec4(1.0), times, greaterThan(times, vec4(u))); }

// The next after u; 1 where there is none.
float nextChange(QuinticChanges c, float u) {
    vec3 next = min(leastAbove(c.first, u), leastAbove(vec3(c.second, 2.0), u));
    return min(min(next.x, next.y), min(next.z, 1.0));
}

#ifndef CAMERA_TURNS
// Not where it is proven to be seen at no time between u0 and u1.
bool maybeSeen(vec2 place, SeenTriangle t, float u0, float u1) {
    QuadraticEdges e = quadraticEdges(t.path, place);
    e = QuadraticEdges(quadraticPart(e.edge0, u0, u1), quadraticPart(e.edge1, u0, u1), quadraticPart(e.edge2, u0, u1),
                       e.products);
    return !neverSeen(e, t.doubleSided);
}

// In u; 2 in the places that are free.
struct EdgeChanges {
    vec3 first, second;
    vec3 atNearPlane;
};

float nextChange(EdgeChanges c, float u) {
    vec3 next = min(min(leastAbove(c.first, u), leastAbove(c.second, u)), leastAbove(c.atNearPlane, u));
    return min(min(next.x, next.y), min(next.z, 1.0));
}

EdgeChanges edgeChanges(vec2 place, SeenTriangle t) {
    QuadraticEdges e = quadraticEdges(t.path, place);
    EdgeChanges c = EdgeChanges(vec3(2.0), vec3(2.0), vec3(2.0));
    SignChanges c0 = signChangesOfQuadratic(e.edge0.x, e.edge0.y, e.edge0.z);
    SignChanges c1 = signChangesOfQuadratic(e.edge1.x, e.edge1.y, e.edge1.z);
    SignChanges c2 = signChangesOfQuadratic(e.edge2.x, e.edge2.y, e.edge2.z);
    if (c0.count > 0u) c.first.x = c0.first;
    if (c1.count > 0u) c.first.y = c1.first;
    if (c2.count > 0u) c.first.z = c2.first;
    if (c0.count > 1u) c.second.x = c0.second;
    if (c1.count > 1u) c.second.y = c1.second;
    if (c2.count > 1u) c.second.z = c2.second;
    ONLY_IF(reachesNearPlane(t.path)) {
        CubicSignChanges found =
            signChangesOfCubic(beyondDepth(t.path, e, cameraView.nearDistance));
        if (found.count > 0u) c.atNearPlane.x = found.at.x;
        if (found.count > 1u) c.atNearPlane.y = found.at.y;
        if (found.count > 2u) c.atNearPlane.z = found.at.z;
    }
    return c;
}

#define OrderChanges QuinticChanges

// Those between u0 and u1, and maybe others. `isFirst`: a stands before b in the mesh; the same times are found of the
// two in either order.
OrderChanges orderChanges(vec2 place, ViewPath a, ViewPath b, bool isStatic, float staticDistance, bool isFirst,
                          float u0, float u1) {
    DepthAlongRay mine = depthAlongRay(a, quadraticEdges(a, place)), theirs = staticDepthAlongRay(staticDistance);
    if (!isStatic) theirs = depthAlongRay(b, quadraticEdges(b, place));
    Quintic order = orderOf(mine, theirs);
    if (!isFirst) order = Quintic(-order.low, -order.high);
    vec2 mineDepths = depthsOf(a), theirDepths = isStatic ? vec2(staticDistance) : depthsOf(b);
    float span = max(mineDepths.y, theirDepths.y) - min(mineDepths.x, theirDepths.x);
    float doubt = orderDoubt(mine, theirs, span);
    // A little more than what is wanted, for what is rounded.
    Quintic wanted = quinticPart(order, max(u0 - 1.0 / 65536.0, 0.0), min(u1 + 1.0 / 65536.0, 1.0));
    QuinticChanges changes = QuinticChanges(vec3(2.0), vec2(2.0));
    ONLY_IF(leastOf(wanted) < -doubt && mostOf(wanted) > doubt) changes = quinticChanges(order, doubt);
    return changes;
}
#else
TurningPolynomials polynomialsOf(ViewPath v, vec2 place) {
    return turningPolynomials(v, rayAt(place, 0.0), rayAt(place, 1.0));
}

bool maybeSeen(vec2 place, SeenTriangle t, float u0, float u1) {
    TurningPolynomials p = polynomialsOf(t.path, place);
    return !neverSeen(quinticPart(p.edge0, u0, u1), quinticPart(p.edge1, u0, u1), quinticPart(p.edge2, u0, u1),
                      t.doubleSided);
}

// In u, in no order.
struct EdgeChanges {
    QuinticChanges edge0, edge1, edge2, atNearPlane;
};
#define OrderChanges NonicChanges

float nextChange(EdgeChanges c, float u) {
    return min(min(nextChange(c.edge0, u), nextChange(c.edge1, u)),
               min(nextChange(c.edge2, u), nextChange(c.atNearPlane, u)));
}

float nextChange(NonicChanges c, float u) {
    vec4 next = min(min(leastAbove(c.first, u), leastAbove(c.second, u)), leastAbove(vec4(c.last), u));
    return min(min(next.x, next.y), min(min(next.z, next.w), 1.0));
}

EdgeChanges edgeChanges(vec2 place, SeenTriangle t) {
    TurningPolynomials p = polynomialsOf(t.path, place);
    QuinticChanges none = QuinticChanges(vec3(2.0), vec2(2.0));
    EdgeChanges c = EdgeChanges(none, none, none, none);
    bool isNear = reachesNearPlane(t.path);
    // One solver, which is inlined once.
    for (int k = 0; k < (isNear ? 4 : 3); ++k) {
        Quintic b = k == 0 ? p.edge0 : k == 1 ? p.edge1 : p.edge2;
        ONLY_IF(k == 3) b = beyondDepth(p, cameraView.nearDistance, rayAt(place, 0.0).z, rayAt(place, 1.0).z);
        QuinticChanges found = quinticChanges(b, 0.0);
        if (k == 0) c.edge0 = found;
        if (k == 1) c.edge1 = found;
        if (k == 2) c.edge2 = found;
        if (k == 3) c.atNearPlane = found;
    }
    return c;
}

// As above. What is static before a view that turns is the background, which has no depth.
OrderChanges orderChanges(vec2 place, ViewPath a, ViewPath b, bool isStatic, float staticDistance, bool isFirst,
                          float u0, float u1) {
    TurningPolynomials mine = polynomialsOf(a, place), theirs = polynomialsOf(b, place);
    Nonic order = orderOf(mine, theirs);
    if (!isFirst) order = Nonic(-order.low, -order.middle, -order.high);
    float doubt = orderDoubt(mine, theirs);
    Nonic wanted = nonicPart(order, max(u0 - 1.0 / 65536.0, 0.0), min(u1 + 1.0 / 65536.0, 1.0));
    OrderChanges changes = noNonicChanges();
    ONLY_IF(leastOf(wanted) < -doubt && mostOf(wanted) > doubt) changes = nonicChanges(order, doubt);
    return changes;
}
#endif
