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
