#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

SHARED_BEGIN

/// Signed double areas (e0, e1, e2) spanned by the ray of a view and the edges opposite to the vertices, where
/// q_i = (X_i - s W_i, Y_i - t W_i) is a vertex seen from the ray through the image position (s, t). The ray
/// meets the triangle iff all three have one sign (or are 0) and their sum is not 0; then e_i / sum are the
/// barycentric coordinates of the point in space, under perspective as well. Subtracting the ray first keeps full
/// precision near contacts, and swapping the ends of an edge flips the sign exactly, so that neighbours leave no gap
/// (needs a*b - c*d without contraction).
SHARED_FUNCTION vec3 edgeFunctions(vec2 q0, vec2 q1, vec2 q2) {
    return vec3(q1.x * q2.y - q1.y * q2.x, q2.x * q0.y - q2.y * q0.x, q0.x * q1.y - q0.y * q1.x);
}

/// How fast the depth dot(e, z) / (e.x + e.y + e.z), e = edgeFunctions(q0, q1, q2), changes at a fixed image position:
/// q_i move at the rates r_i, the vertices' depths z at the rates zRate. That is the depth that a map's texel sees, not
/// that of a material point: a slope that slides along itself has the rate 0. Its relative error is that of the edge
/// functions over their sum: without bound for a triangle that the ray only grazes, so that callers hold it to what the
/// vertices' depths allow.
SHARED_FUNCTION float depthRateAtPlace(vec2 q0, vec2 q1, vec2 q2, vec2 r0, vec2 r1, vec2 r2, vec3 z, vec3 zRate) {
    vec3 e = edgeFunctions(q0, q1, q2);
    float sum = e.x + e.y + e.z;
    vec3 below = z - dot(e, z) / sum;
    vec3 eRate = vec3(r1.x * q2.y - r1.y * q2.x + q1.x * r2.y - q1.y * r2.x,
                      r2.x * q0.y - r2.y * q0.x + q2.x * r0.y - q2.y * r0.x,
                      r0.x * q1.y - r0.y * q1.x + q0.x * r1.y - q0.y * r1.x);
    return (dot(eRate, below) + dot(e, zRate)) / sum;
}

/// Triple product a . (b x c).
SHARED_FUNCTION float determinant3(vec3 a, vec3 b, vec3 c) { return dot(a, cross(b, c)); }

/// Bernstein coefficients over the interval of det[v0, v1, v2] for three points that move linearly from a_i to b_i
/// (blossom of the cubic). All of one sign: the determinant keeps that sign throughout.
SHARED_FUNCTION vec4 determinantCoefficients(vec3 a0, vec3 a1, vec3 a2, vec3 b0, vec3 b1, vec3 b2) {
    return vec4(determinant3(a0, a1, a2),
                (determinant3(b0, a1, a2) + determinant3(a0, b1, a2) + determinant3(a0, a1, b2)) / SHARED_FLOAT(3.0),
                (determinant3(b0, b1, a2) + determinant3(b0, a1, b2) + determinant3(a0, b1, b2)) / SHARED_FLOAT(3.0),
                determinant3(b0, b1, b2));
}

SHARED_END
