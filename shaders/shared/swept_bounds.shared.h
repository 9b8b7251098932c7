#ifdef __cplusplus
#pragma once
#endif
#include "shared/moving_triangle.shared.h"

SHARED_BEGIN

/// Where in the image a moving triangle may be seen during an interval of time.
struct SweptBounds {
    vec2 low;  // image position, [0, 1] covers the image; low > high where nothing can be seen
    vec2 high;
    uint crosses;  // 1: the triangle reaches behind the eye
};

/// Extremes of X/Z and Y/Z over a set of homogeneous points, apart for those in front of the eye and those behind.
struct HomogeneousExtremes {
    vec2 frontLow, frontHigh;
    vec2 behindLow, behindHigh;
};

SHARED_FUNCTION HomogeneousExtremes addHomogeneousPoint(HomogeneousExtremes x, vec3 p) {
    if (p.z > SHARED_FLOAT(1e-30)) {
        vec2 q = vec2(p) / p.z;
        x.frontLow = min(x.frontLow, q);
        x.frontHigh = max(x.frontHigh, q);
    } else {
        vec2 q = vec2(p) / min(p.z, -SHARED_FLOAT(1e-30));
        x.behindLow = min(x.behindLow, q);
        x.behindHigh = max(x.behindHigh, q);
    }
    return x;
}

SHARED_FUNCTION HomogeneousExtremes noHomogeneousPoints() {
    HomogeneousExtremes x;
    x.frontLow = x.behindLow = vec2(SHARED_FLOAT(1e37));
    x.frontHigh = x.behindHigh = vec2(-SHARED_FLOAT(1e37));
    return x;
}

/// Image bounds of whatever lies in the hull of the points and in front of the eye. A number s is a lower bound iff
/// X - s Z >= 0 at every point: s <= X/Z for the points in front and s >= X/Z for those behind. So the least X/Z in
/// front is a bound unless a point behind contradicts it; then there is none, and the image's own border is taken.
SHARED_FUNCTION SweptBounds boundsOfExtremes(HomogeneousExtremes x) {
    SweptBounds bounds;
    bounds.low.x = x.frontLow.x >= x.behindHigh.x ? x.frontLow.x : SHARED_FLOAT(0.0);
    bounds.low.y = x.frontLow.y >= x.behindHigh.y ? x.frontLow.y : SHARED_FLOAT(0.0);
    bounds.high.x = x.frontHigh.x <= x.behindLow.x ? x.frontHigh.x : SHARED_FLOAT(1.0);
    bounds.high.y = x.frontHigh.y <= x.behindLow.y ? x.frontHigh.y : SHARED_FLOAT(1.0);
    bounds.crosses = x.behindLow.x < SHARED_FLOAT(1e37) ? 1u : 0u;
    return bounds;
}

/// Bounds of a triangle whose view coordinates go linearly from a_i to b_i, for a view that does not turn: a path
/// that is linear in (X, Y, Z) stays in the hull of its ends.
SHARED_FUNCTION SweptBounds sweptBoundsPerspective(vec3 a0, vec3 a1, vec3 a2, vec3 b0, vec3 b1, vec3 b2,
                                                   float nearDistance) {
    HomogeneousExtremes x =
        addHomogeneousPoint(addHomogeneousPoint(addHomogeneousPoint(noHomogeneousPoints(), a0), a1), a2);
    SweptBounds bounds = boundsOfExtremes(addHomogeneousPoint(addHomogeneousPoint(addHomogeneousPoint(x, b0), b1), b2));
    if (!(max(max(max(a0.z, a1.z), max(a2.z, b0.z)), max(b1.z, b2.z)) > nearDistance)) {
        bounds.low = vec2(1);  // all of it nearer than anything that is seen
        bounds.high = vec2(0);
    }
    return bounds;
}

SHARED_FUNCTION SweptBounds sweptBoundsOrthographic(vec3 a0, vec3 a1, vec3 a2, vec3 b0, vec3 b1, vec3 b2) {
    SweptBounds bounds;
    bounds.low = min(min(min(vec2(a0), vec2(a1)), min(vec2(a2), vec2(b0))), min(vec2(b1), vec2(b2)));
    bounds.high = max(max(max(vec2(a0), vec2(a1)), max(vec2(a2), vec2(b0))), max(vec2(b1), vec2(b2)));
    bounds.crosses = 0u;
    return bounds;
}

/// Adds one vertex of a turning view. The ray of (s, t) is D(u) (s, t, 1) with the columns of D linear in u, so the
/// homogeneous image position of a point v is (v . (C x A), v . (A x B), v . (B x C)) for D = [B C A]: quadratic
/// normals times a linear path, a rational cubic, which stays in the hull of its four Bezier points.
SHARED_FUNCTION HomogeneousExtremes addTurningVertex(HomogeneousExtremes x, vec3 va, vec3 vb, mat4 raysA, mat4 raysB) {
    vec3 colA0 = vec3(raysA[0]), colA1 = vec3(raysA[1]), colA2 = vec3(raysA[2]);
    vec3 colB0 = vec3(raysB[0]), colB1 = vec3(raysB[1]), colB2 = vec3(raysB[2]);
    vec3 x0 = cross(colA1, colA2), x2 = cross(colB1, colB2);
    vec3 y0 = cross(colA2, colA0), y2 = cross(colB2, colB0);
    vec3 z0 = cross(colA0, colA1), z2 = cross(colB0, colB1);
    vec3 x1 = SHARED_FLOAT(0.5) * (cross(colA1, colB2) + cross(colB1, colA2));
    vec3 y1 = SHARED_FLOAT(0.5) * (cross(colA2, colB0) + cross(colB2, colA0));
    vec3 z1 = SHARED_FLOAT(0.5) * (cross(colA0, colB1) + cross(colB0, colA1));
    float two = SHARED_FLOAT(2.0), third = SHARED_FLOAT(1.0) / SHARED_FLOAT(3.0);
    x = addHomogeneousPoint(x, vec3(dot(x0, va), dot(y0, va), dot(z0, va)));
    x = addHomogeneousPoint(
        x, (vec3(dot(x0, vb), dot(y0, vb), dot(z0, vb)) + two * vec3(dot(x1, va), dot(y1, va), dot(z1, va))) * third);
    x = addHomogeneousPoint(
        x, (vec3(dot(x2, va), dot(y2, va), dot(z2, va)) + two * vec3(dot(x1, vb), dot(y1, vb), dot(z1, vb))) * third);
    return addHomogeneousPoint(x, vec3(dot(x2, vb), dot(y2, vb), dot(z2, vb)));
}

/// Bounds for a view that turns by less than half a circle.
SHARED_FUNCTION SweptBounds sweptBoundsTurning(vec3 a0, vec3 a1, vec3 a2, vec3 b0, vec3 b1, vec3 b2, mat4 raysA,
                                               mat4 raysB) {
    HomogeneousExtremes x = addTurningVertex(noHomogeneousPoints(), a0, b0, raysA, raysB);
    x = addTurningVertex(addTurningVertex(x, a1, b1, raysA, raysB), a2, b2, raysA, raysB);
    return boundsOfExtremes(x);
}

SHARED_END
