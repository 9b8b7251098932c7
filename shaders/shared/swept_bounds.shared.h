#ifdef __cplusplus
#pragma once
#endif
#include "shared/moving_triangle.shared.h"

SHARED_BEGIN

/// Where in the image a moving triangle may be seen during an interval of time.
struct SweptBounds {
    vec2 low;      // image position, [0, 1] covers the image; low > high where nothing can be seen
    vec2 high;
    uint crosses;  // 1: the triangle reaches behind the near plane, and the bounds are the whole image
};

/// Bounds of a triangle whose view coordinates go linearly from a_i to b_i, for a view that does not turn.
/// Perspective: a path that is linear in (X, Y, Z) with Z > 0 is seen inside the hull of its ends.
SHARED_FUNCTION SweptBounds sweptBoundsPerspective(vec3 a0, vec3 a1, vec3 a2, vec3 b0, vec3 b1, vec3 b2, float nearDistance) {
    SweptBounds bounds;
    float nearest = min(min(min(a0.z, a1.z), min(a2.z, b0.z)), min(b1.z, b2.z));
    float farthest = max(max(max(a0.z, a1.z), max(a2.z, b0.z)), max(b1.z, b2.z));
    vec2 pa0 = vec2(a0) / a0.z;
    vec2 pa1 = vec2(a1) / a1.z;
    vec2 pa2 = vec2(a2) / a2.z;
    vec2 pb0 = vec2(b0) / b0.z;
    vec2 pb1 = vec2(b1) / b1.z;
    vec2 pb2 = vec2(b2) / b2.z;
    bounds.low = min(min(min(pa0, pa1), min(pa2, pb0)), min(pb1, pb2));
    bounds.high = max(max(max(pa0, pa1), max(pa2, pb0)), max(pb1, pb2));
    bounds.crosses = 0u;
    if (!(nearest > nearDistance)) {
        bool visible = farthest > nearDistance;
        bounds.low = visible ? vec2(0) : vec2(1);
        bounds.high = visible ? vec2(1) : vec2(0);
        bounds.crosses = visible ? 1u : 0u;
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
/// normals times a linear path, a rational cubic. It is seen inside the hull of its four Bezier points.
/// `nearest` collects the least homogeneous weight: at or below 0 the bounds say nothing.
SHARED_FUNCTION SweptBounds addTurningVertex(SweptBounds bounds, vec3 va, vec3 vb, mat4 raysA, mat4 raysB) {
    vec3 colA0 = vec3(raysA[0]), colA1 = vec3(raysA[1]), colA2 = vec3(raysA[2]);
    vec3 colB0 = vec3(raysB[0]), colB1 = vec3(raysB[1]), colB2 = vec3(raysB[2]);
    vec3 x0 = cross(colA1, colA2), x2 = cross(colB1, colB2);
    vec3 y0 = cross(colA2, colA0), y2 = cross(colB2, colB0);
    vec3 w0 = cross(colA0, colA1), w2 = cross(colB0, colB1);
    vec3 x1 = SHARED_FLOAT(0.5) * (cross(colA1, colB2) + cross(colB1, colA2));
    vec3 y1 = SHARED_FLOAT(0.5) * (cross(colA2, colB0) + cross(colB2, colA0));
    vec3 w1 = SHARED_FLOAT(0.5) * (cross(colA0, colB1) + cross(colB0, colA1));
    float two = SHARED_FLOAT(2.0), third = SHARED_FLOAT(1.0) / SHARED_FLOAT(3.0);
    vec3 p0 = vec3(dot(x0, va), dot(y0, va), dot(w0, va));
    vec3 p1 = (vec3(dot(x0, vb), dot(y0, vb), dot(w0, vb)) + two * vec3(dot(x1, va), dot(y1, va), dot(w1, va))) * third;
    vec3 p2 = (vec3(dot(x2, va), dot(y2, va), dot(w2, va)) + two * vec3(dot(x1, vb), dot(y1, vb), dot(w1, vb))) * third;
    vec3 p3 = vec3(dot(x2, vb), dot(y2, vb), dot(w2, vb));
    float nearest = min(min(p0.z, p1.z), min(p2.z, p3.z));
    if (!(nearest > SHARED_FLOAT(1e-6))) {
        bounds.crosses = 1u;
        return bounds;
    }
    vec2 q0 = vec2(p0) / p0.z, q1 = vec2(p1) / p1.z, q2 = vec2(p2) / p2.z, q3 = vec2(p3) / p3.z;
    bounds.low = min(bounds.low, min(min(q0, q1), min(q2, q3)));
    bounds.high = max(bounds.high, max(max(q0, q1), max(q2, q3)));
    return bounds;
}

/// Bounds for a view that turns; a vertex at or behind the eye makes them the whole image.
SHARED_FUNCTION SweptBounds sweptBoundsTurning(vec3 a0, vec3 a1, vec3 a2, vec3 b0, vec3 b1, vec3 b2, mat4 raysA, mat4 raysB) {
    SweptBounds bounds;
    bounds.low = vec2(SHARED_FLOAT(1e30));
    bounds.high = vec2(SHARED_FLOAT(-1e30));
    bounds.crosses = 0u;
    bounds = addTurningVertex(bounds, a0, b0, raysA, raysB);
    bounds = addTurningVertex(bounds, a1, b1, raysA, raysB);
    bounds = addTurningVertex(bounds, a2, b2, raysA, raysB);
    if (bounds.crosses == 1u) {
        bounds.low = vec2(0);
        bounds.high = vec2(1);
    }
    return bounds;
}

SHARED_END
