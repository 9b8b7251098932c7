#ifdef __cplusplus
#pragma once
#endif
#include "shared/moving_triangle.shared.h"

// When does a moving triangle cover a point of an image? Its vertices seen from the point, q_i = (X_i - s Z_i, Y_i - t
// Z_i), are linear in u for a view that does not turn, so the three edge functions are quadratics, and the times at
// which all three have one sign are a few intervals between their roots.

#define MAX_INTERVALS 4

SHARED_BEGIN

/// The three edge functions over the shutter as Bernstein polynomials: e(u) = at0 (1 - u)^2 + 2 at1 u (1 - u) + at2
/// u^2.
struct EdgeQuadratics {
    vec3 at0, at1, at2;
};

/// Vertices as seen from the point: a_i at u = 0, b_i at u = 1.
SHARED_FUNCTION EdgeQuadratics edgeQuadratics(vec2 a0, vec2 a1, vec2 a2, vec2 b0, vec2 b1, vec2 b2) {
    EdgeQuadratics e;
    e.at0 = edgeFunctions(a0, a1, a2);
    e.at2 = edgeFunctions(b0, b1, b2);
    e.at1 = SHARED_FLOAT(0.5) * vec3((a1.x * b2.y - a1.y * b2.x) + (b1.x * a2.y - b1.y * a2.x),
                                     (a2.x * b0.y - a2.y * b0.x) + (b2.x * a0.y - b2.y * a0.x),
                                     (a0.x * b1.y - a0.y * b1.x) + (b0.x * a1.y - b0.y * a1.x));
    return e;
}

SHARED_FUNCTION vec3 edgesAt(EdgeQuadratics e, float u) {
    float v = SHARED_FLOAT(1.0) - u;
    return e.at0 * (v * v) + e.at1 * (SHARED_FLOAT(2.0) * u * v) + e.at2 * (u * u);
}

/// 1 or -1 where the point is inside the triangle, seen from one side or from the other; else 0.
SHARED_FUNCTION float sideAt(EdgeQuadratics e, float u) {
    vec3 at = edgesAt(e, u);
    float least = min(min(at.x, at.y), at.z), most = max(max(at.x, at.y), at.z);
    return least >= SHARED_FLOAT(0.0) && most > SHARED_FLOAT(0.0)   ? SHARED_FLOAT(1.0)
           : most <= SHARED_FLOAT(0.0) && least < SHARED_FLOAT(0.0) ? -SHARED_FLOAT(1.0)
                                                                    : SHARED_FLOAT(0.0);
}

/// Is this quadratic positive all over [0, 1]? Exactly: a dip between positive ends reaches 0 iff b1^2 >= b0 b2.
SHARED_FUNCTION bool staysPositive(float b0, float b1, float b2) {
    return b0 > SHARED_FLOAT(0.0) && b2 > SHARED_FLOAT(0.0) && (b1 >= SHARED_FLOAT(0.0) || b1 * b1 < b0 * b2);
}

/// Is the point inside the triangle all through the shutter, seen from one side?
SHARED_FUNCTION bool coversThroughout(EdgeQuadratics e) {
    return (staysPositive(e.at0.x, e.at1.x, e.at2.x) && staysPositive(e.at0.y, e.at1.y, e.at2.y) &&
            staysPositive(e.at0.z, e.at1.z, e.at2.z)) ||
           (staysPositive(-e.at0.x, -e.at1.x, -e.at2.x) && staysPositive(-e.at0.y, -e.at1.y, -e.at2.y) &&
            staysPositive(-e.at0.z, -e.at1.z, -e.at2.z));
}

/// Is it plain from the coefficients' signs that the point is never inside?
SHARED_FUNCTION bool neverCovers(EdgeQuadratics e) {
    vec3 least = min(min(e.at0, e.at1), e.at2), most = max(max(e.at0, e.at1), e.at2);
    return max(max(least.x, least.y), least.z) > SHARED_FLOAT(0.0) &&
           min(min(most.x, most.y), most.z) < SHARED_FLOAT(0.0);
}

/// numerator / denominator where that lies inside (0, 1), else 0: a time that changes nothing.
SHARED_FUNCTION float timeInside(float numerator, float denominator) {
    bool inside =
        (numerator > SHARED_FLOAT(0.0)) == (denominator > SHARED_FLOAT(0.0)) && abs(numerator) < abs(denominator);
    return inside ? numerator / denominator : SHARED_FLOAT(0.0);
}

/// The roots in (0, 1) of a Bernstein quadratic, in no order; 0 for one that is not there. Without cancellation (q =
/// -(h + sign(h) sqrt(D)), roots q / a and c / q for a u^2 + 2 h u + c). No root, D < 0, gives the extremum's place,
/// which does no harm.
SHARED_FUNCTION vec2 rootsInside(float b0, float b1, float b2) {
    float h = b1 - b0, a = (b0 - b1) + (b2 - b1);
    float root = sqrt(max(b1 * b1 - b0 * b2, SHARED_FLOAT(0.0)));
    float q = h > SHARED_FLOAT(0.0) ? -(h + root) : root - h;
    return vec2(timeInside(q, a), timeInside(b0, q));
}

/// When the triangle covers the point: `count` intervals from begins[i] to ends[i], in order, apart or (where the
/// triangle turns over in an instant) touching.
struct CoverageIntervals {
    int count;
    vec4 begins, ends;
};

#define SORT_TIMES(a, b)          \
    {                             \
        float lesser = min(a, b); \
        b = max(a, b);            \
        a = lesser;               \
    }
#define COVERAGE_GAP(from, to)                                                              \
    {                                                                                       \
        float side = (to) > (from) ? sideAt(e, SHARED_FLOAT(0.5) * ((from) + (to))) : open; \
        if (side != open) {                                                                 \
            if (open != SHARED_FLOAT(0.0) && intervals.count < MAX_INTERVALS) {             \
                intervals.begins[intervals.count] = begin;                                  \
                intervals.ends[intervals.count] = from;                                     \
                ++intervals.count;                                                          \
            }                                                                               \
            open = side;                                                                    \
            begin = from;                                                                   \
        }                                                                                   \
    }

/// Cuts the shutter at all roots, and tests in the middle of each gap which side is seen there: a root that is missed,
/// found twice or put a little aside costs no more than the gap beside it.
SHARED_FUNCTION CoverageIntervals intervalsBetweenRoots(EdgeQuadratics e) {
    CoverageIntervals intervals;
    intervals.count = 0;
    intervals.begins = intervals.ends = vec4(SHARED_FLOAT(0.0));
    vec2 x = rootsInside(e.at0.x, e.at1.x, e.at2.x), y = rootsInside(e.at0.y, e.at1.y, e.at2.y),
         z = rootsInside(e.at0.z, e.at1.z, e.at2.z);
    float t1 = x.x, t2 = x.y, t3 = y.x, t4 = y.y, t5 = z.x, t6 = z.y;
    SORT_TIMES(t1, t6);
    SORT_TIMES(t2, t4);
    SORT_TIMES(t3, t5);
    SORT_TIMES(t2, t3);
    SORT_TIMES(t4, t5);
    SORT_TIMES(t1, t4);
    SORT_TIMES(t3, t6);
    SORT_TIMES(t1, t2);
    SORT_TIMES(t3, t4);
    SORT_TIMES(t5, t6);
    SORT_TIMES(t2, t3);
    SORT_TIMES(t4, t5);
    float open = SHARED_FLOAT(0.0), begin = SHARED_FLOAT(0.0);
    COVERAGE_GAP(SHARED_FLOAT(0.0), t1);
    COVERAGE_GAP(t1, t2);
    COVERAGE_GAP(t2, t3);
    COVERAGE_GAP(t3, t4);
    COVERAGE_GAP(t4, t5);
    COVERAGE_GAP(t5, t6);
    COVERAGE_GAP(t6, SHARED_FLOAT(1.0));
    if (open != SHARED_FLOAT(0.0) && intervals.count < MAX_INTERVALS) {
        intervals.begins[intervals.count] = begin;
        intervals.ends[intervals.count] = SHARED_FLOAT(1.0);
        ++intervals.count;
    }
    return intervals;
}

#undef SORT_TIMES
#undef COVERAGE_GAP

SHARED_FUNCTION CoverageIntervals intervalsOf(EdgeQuadratics e) {
    CoverageIntervals intervals;
    intervals.count = 0;
    intervals.begins = intervals.ends = vec4(SHARED_FLOAT(0.0));
    if (coversThroughout(e)) {
        intervals.count = 1;
        intervals.ends.x = SHARED_FLOAT(1.0);
    }
    // A loop that runs once where a branch would do: software renderers run both sides of a branch, but skip a loop
    // that no lane enters.
    int rounds = intervals.count == 0 && !neverCovers(e) ? 1 : 0;
    for (int i = 0; i < rounds; ++i) intervals = intervalsBetweenRoots(e);
    return intervals;
}

/// The same for a triangle that does not turn (its vertices move alike): its edge functions are linear in u and it
/// keeps its side, so the interval is what the three edges leave of the shutter.
SHARED_FUNCTION CoverageIntervals intervalsOfTranslation(EdgeQuadratics e) {
    float side = e.at0.x + e.at0.y + e.at0.z < SHARED_FLOAT(0.0) ? -SHARED_FLOAT(1.0) : SHARED_FLOAT(1.0);
    vec3 first = side * e.at0, last = side * e.at2, fall = first - last;
    float begin = max(max(first.x < SHARED_FLOAT(0.0) ? first.x / min(fall.x, first.x) : SHARED_FLOAT(0.0),
                          first.y < SHARED_FLOAT(0.0) ? first.y / min(fall.y, first.y) : SHARED_FLOAT(0.0)),
                      first.z < SHARED_FLOAT(0.0) ? first.z / min(fall.z, first.z) : SHARED_FLOAT(0.0));
    float end = min(min(last.x < SHARED_FLOAT(0.0) ? first.x / max(fall.x, -last.x) : SHARED_FLOAT(1.0),
                        last.y < SHARED_FLOAT(0.0) ? first.y / max(fall.y, -last.y) : SHARED_FLOAT(1.0)),
                    last.z < SHARED_FLOAT(0.0) ? first.z / max(fall.z, -last.z) : SHARED_FLOAT(1.0));
    vec3 larger = max(first, last);
    bool meets = begin < end && min(min(larger.x, larger.y), larger.z) >= SHARED_FLOAT(0.0) &&
                 max(max(larger.x, larger.y), larger.z) > SHARED_FLOAT(0.0);
    CoverageIntervals intervals;
    intervals.count = meets ? 1 : 0;
    intervals.begins = vec4(begin);
    intervals.ends = vec4(end);
    return intervals;
}

/// Distance along the view's axis at which the ray through the point meets the triangle. `q0` .. `q2`: its vertices
/// seen from the point, `distances`: their own. Held between those, so that a triangle seen edge-on gives a distance as
/// well.
SHARED_FUNCTION float distanceAt(vec2 q0, vec2 q1, vec2 q2, vec3 distances) {
    vec3 e = edgeFunctions(q0, q1, q2);
    float sum = e.x + e.y + e.z;
    float least = min(min(distances.x, distances.y), distances.z),
          most = max(max(distances.x, distances.y), distances.z);
    return sum != SHARED_FLOAT(0.0) ? clamp(dot(e, distances) / sum, least, most) : SHARED_FLOAT(0.5) * (least + most);
}

SHARED_END
