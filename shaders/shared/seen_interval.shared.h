#ifdef __cplusplus
#pragma once
#endif
#include "shared/moving_triangle.shared.h"
#include "shared/nonic.shared.h"

SHARED_BEGIN

/// A moving triangle in view coordinates (ViewBlock): linear in u from open to close.
struct ViewPath {
    vec3 open0, open1, open2;
    vec3 close0, close1, close2;
};

/// When the ray of an image position meets a moving triangle, and how far from the eye's plane, as polynomials in u, of
/// a view that turns.
struct TurningPolynomials {
    Quintic edge0, edge1, edge2;  // edgeFunctions, of degree 4
    Quartic area;                 // their sum
    Quintic depth;                // sum of edge times depth: the depth is this over the area, and over the ray's z
};

SHARED_FUNCTION float crossOf2(vec2 a, vec2 b) {
    SHARED_PRECISE float c = a.x * b.y - a.y * b.x;
    return c;
}

/// Bernstein coefficients of a(u) x b(u), both linear. Swapping a and b flips all signs exactly.
SHARED_FUNCTION vec3 edgeOfLinear(vec2 a0, vec2 b0, vec2 a1, vec2 b1) {
    SHARED_PRECISE float middle = crossOf2(a0, b1) + crossOf2(a1, b0);
    return vec3(crossOf2(a0, b0), SHARED_FLOAT(0.5) * middle, crossOf2(a1, b1));
}

/// The three edges of a triangle before a view that does not turn: quadratics in u.
struct QuadraticEdges {
    vec3 edge0, edge1, edge2;
    float products;  // the largest that they are differences of
};

/// A vertex seen from a ray that does not turn.
SHARED_FUNCTION vec2 fromRay(vec3 v, vec2 position) {
    SHARED_PRECISE vec2 q = vec2(v.x - position.x * v.z, v.y - position.y * v.z);
    return q;
}

/// Bernstein coefficients of a vector that is quadratic in u.
struct QuadraticPlace {
    vec2 first, middle, last;
};

/// A vertex seen from a ray that turns, times the ray's z.
SHARED_FUNCTION QuadraticPlace fromTurningRay(vec3 v0, vec3 v1, vec3 ray0, vec3 ray1) {
    SHARED_PRECISE vec2 first = vec2(v0.x * ray0.z - ray0.x * v0.z, v0.y * ray0.z - ray0.y * v0.z);
    SHARED_PRECISE vec2 last = vec2(v1.x * ray1.z - ray1.x * v1.z, v1.y * ray1.z - ray1.y * v1.z);
    SHARED_PRECISE vec2 one = vec2(v0.x * ray1.z - ray1.x * v0.z, v0.y * ray1.z - ray1.y * v0.z);
    SHARED_PRECISE vec2 other = vec2(v1.x * ray0.z - ray0.x * v1.z, v1.y * ray0.z - ray0.y * v1.z);
    return QuadraticPlace(first, SHARED_FLOAT(0.5) * (one + other), last);
}

/// a(u) x b(u), both quadratic. Swapping a and b flips all signs exactly.
SHARED_FUNCTION Quartic edgeOfQuadratic(QuadraticPlace a, QuadraticPlace b) {
    const float oneHalf = SHARED_FLOAT(0.5), four = SHARED_FLOAT(4.0), sixth = SHARED_FLOAT(0.16666667);
    SHARED_PRECISE float c1 = oneHalf * (crossOf2(a.first, b.middle) + crossOf2(a.middle, b.first));
    SHARED_PRECISE float ends = crossOf2(a.first, b.last) + crossOf2(a.last, b.first);
    SHARED_PRECISE float c2 = sixth * (ends + four * crossOf2(a.middle, b.middle));
    SHARED_PRECISE float c3 = oneHalf * (crossOf2(a.middle, b.last) + crossOf2(a.last, b.middle));
    return Quartic(vec4(crossOf2(a.first, b.first), c1, c2, c3), crossOf2(a.last, b.last));
}

SHARED_FUNCTION QuadraticEdges quadraticEdges(ViewPath v, vec2 position) {
    vec2 a0 = fromRay(v.open0, position), a1 = fromRay(v.open1, position), a2 = fromRay(v.open2, position);
    vec2 b0 = fromRay(v.close0, position), b1 = fromRay(v.close1, position), b2 = fromRay(v.close2, position);
    vec2 most = max(max(max(abs(a0), abs(a1)), max(abs(a2), abs(b0))), max(abs(b1), abs(b2)));
    return QuadraticEdges(edgeOfLinear(a1, a2, b1, b2), edgeOfLinear(a2, a0, b2, b0), edgeOfLinear(a0, a1, b0, b1),
                          most.x * most.y);
}

/// The part from `low` to `high`, again over [0, 1].
SHARED_FUNCTION vec3 quadraticPart(vec3 b, float low, float high) {
    vec2 atLow = mix(vec2(b.x, b.y), vec2(b.y, b.z), low), atHigh = mix(vec2(b.x, b.y), vec2(b.y, b.z), high);
    return vec3(mix(atLow.x, atLow.y, low), mix(atLow.x, atLow.y, high), mix(atHigh.x, atHigh.y, high));
}

SHARED_FUNCTION float leastOf3(vec3 b) { return min(min(b.x, b.y), b.z); }
SHARED_FUNCTION float mostOf3(vec3 b) { return max(max(b.x, b.y), b.z); }

/// Is the triangle proven to be met at no time, from its front or, if it is two-sided, from its back?
SHARED_FUNCTION bool neverSeen(QuadraticEdges e, bool doubleSided) {
    float most = min(min(mostOf3(e.edge0), mostOf3(e.edge1)), mostOf3(e.edge2));
    float least = max(max(leastOf3(e.edge0), leastOf3(e.edge1)), leastOf3(e.edge2));
    return most < SHARED_FLOAT(0.0) && (!doubleSided || least > SHARED_FLOAT(0.0));
}

/// How deep what the ray meets is, as depth(u) / area(u): Bernstein coefficients of a cubic and a quadratic.
struct DepthAlongRay {
    vec4 depth;
    vec3 area;
    float edges;  // the largest product that an edge function is a difference of
};

/// Of a quadratic times what goes linearly from `first` to `last`.
SHARED_FUNCTION vec4 cubicProduct(vec3 q, float first, float last) {
    const float third = SHARED_FLOAT(0.33333334), two = SHARED_FLOAT(2.0);
    return vec4(q.x * first, third * (q.x * last + two * q.y * first), third * (two * q.y * last + q.z * first),
                q.z * last);
}

SHARED_FUNCTION DepthAlongRay depthAlongRay(ViewPath v, QuadraticEdges e) {
    return DepthAlongRay(cubicProduct(e.edge0, v.open0.z, v.close0.z) + cubicProduct(e.edge1, v.open1.z, v.close1.z) +
                             cubicProduct(e.edge2, v.open2.z, v.close2.z),
                         e.edge0 + e.edge1 + e.edge2, e.products);
}

/// Of what does not move before the view.
SHARED_FUNCTION DepthAlongRay staticDepthAlongRay(float depth) {
    return DepthAlongRay(vec4(depth), vec3(SHARED_FLOAT(1.0)), SHARED_FLOAT(0.0));
}

/// Its sign changes where the two change their order in depth, and where one of them turns its other side to the view.
/// Swapping the two flips all signs.
SHARED_FUNCTION Quintic orderOf(DepthAlongRay a, DepthAlongRay b) {
    return quinticDifference(quinticProduct(a.depth, b.area), quinticProduct(b.depth, a.area));
}

/// How far orderOf may be off: 2^-20 of its terms, and of two whose edges are much longer than their areas, 2^-20 of
/// the edges' products times how far apart the depths are. Two that lie in one plane differ by no more.
SHARED_FUNCTION float orderDoubt(DepthAlongRay a, DepthAlongRay b, float depthSpan) {
    vec4 depthA = abs(a.depth), depthB = abs(b.depth);
    vec3 areaA = abs(a.area), areaB = abs(b.area);
    float mostA = max(max(areaA.x, areaA.y), areaA.z), mostB = max(max(areaB.x, areaB.y), areaB.z);
    float termA = max(max(depthA.x, depthA.y), max(depthA.z, depthA.w)) * mostB;
    float termB = max(max(depthB.x, depthB.y), max(depthB.z, depthB.w)) * mostA;
    return SHARED_FLOAT(9.5367432e-7) * (termA + termB + (a.edges * mostB + b.edges * mostA) * depthSpan);
}

/// Its sign changes where the depth passes `least`. From what each vertex is beyond it: the depth times the area has
/// lost that where the two nearly cancel.
SHARED_FUNCTION vec4 beyondDepth(ViewPath v, QuadraticEdges e, float least) {
    return cubicProduct(e.edge0, v.open0.z - least, v.close0.z - least) +
           cubicProduct(e.edge1, v.open1.z - least, v.close1.z - least) +
           cubicProduct(e.edge2, v.open2.z - least, v.close2.z - least);
}

/// Of a view that turns, whose ray goes from ray0 to ray1: degree 4, the cubic det[ray, v, v] times the ray's z.
SHARED_FUNCTION TurningPolynomials turningPolynomials(ViewPath v, vec3 ray0, vec3 ray1) {
    QuadraticPlace q0 = fromTurningRay(v.open0, v.close0, ray0, ray1),
                   q1 = fromTurningRay(v.open1, v.close1, ray0, ray1),
                   q2 = fromTurningRay(v.open2, v.close2, ray0, ray1);
    Quartic e0 = edgeOfQuadratic(q1, q2), e1 = edgeOfQuadratic(q2, q0), e2 = edgeOfQuadratic(q0, q1);
    const float one = SHARED_FLOAT(1.0);
    return TurningPolynomials(
        quinticOfQuartic(e0, one, one), quinticOfQuartic(e1, one, one), quinticOfQuartic(e2, one, one),
        quarticSum(quarticSum(e0, e1), e2),
        quinticSum(quinticSum(quinticOfQuartic(e0, v.open0.z, v.close0.z), quinticOfQuartic(e1, v.open1.z, v.close1.z)),
                   quinticOfQuartic(e2, v.open2.z, v.close2.z)));
}

/// Is the triangle proven to be met at no time, from its front or, if it is two-sided, from its back?
SHARED_FUNCTION bool neverSeen(Quintic edge0, Quintic edge1, Quintic edge2, bool doubleSided) {
    float most = min(min(mostOf(edge0), mostOf(edge1)), mostOf(edge2));
    float least = max(max(leastOf(edge0), leastOf(edge1)), leastOf(edge2));
    return most < SHARED_FLOAT(0.0) && (!doubleSided || least > SHARED_FLOAT(0.0));
}

SHARED_FUNCTION float sizeOf(Quintic p) { return max(-leastOf(p), mostOf(p)); }
SHARED_FUNCTION float sizeOf(Quartic p) {
    vec4 size = abs(p.low);
    return max(max(max(size.x, size.y), max(size.z, size.w)), abs(p.last));
}

/// As orderOf of a view that does not turn.
SHARED_FUNCTION Nonic orderOf(TurningPolynomials a, TurningPolynomials b) {
    return nonicDifference(nonicProduct(a.depth, b.area), nonicProduct(b.depth, a.area));
}

SHARED_FUNCTION float orderDoubt(TurningPolynomials a, TurningPolynomials b) {
    return SHARED_FLOAT(9.5367432e-7) * (sizeOf(a.depth) * sizeOf(b.area) + sizeOf(b.depth) * sizeOf(a.area));
}

/// Its sign changes where the depth passes `least`; the ray's z goes from z0 to z1.
SHARED_FUNCTION Quintic beyondDepth(TurningPolynomials a, float least, float z0, float z1) {
    return quinticDifference(a.depth, quinticOfQuartic(a.area, least * z0, least * z1));
}

SHARED_END
