#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// Intervals of a texel (Palmér 2011, section 2.1): from when to when a triangle covers the texel's centre, and how far
// from the light it is at both ends; in between the distance is taken as linear in u. What two of them leave of each
// other, and what is lost where one stands for both.

#define NO_INTERVAL_ID 0xFFFFFFFFu  // of no triangle: what is merged of several

SHARED_BEGIN

struct MapInterval {
    float begin, end;            // u; nothing where begin > end
    float depthBegin, depthEnd;  // distances along the light's axis, world units
    uint id;                     // the triangle's number
};

/// What stands at the places of a list that are left over: behind all others in order, and at no time.
SHARED_FUNCTION MapInterval noInterval() {
    MapInterval i;
    i.begin = SHARED_FLOAT(2.0);
    i.end = SHARED_FLOAT(-1.0);
    i.depthBegin = i.depthEnd = SHARED_FLOAT(0.0);
    i.id = NO_INTERVAL_ID;
    return i;
}

/// Distance at u. At both ends exactly what is stored.
SHARED_FUNCTION float depthAt(MapInterval i, float u) {
    float length = i.end - i.begin;
    float share = length > SHARED_FLOAT(0.0) ? clamp((u - i.begin) / length, SHARED_FLOAT(0.0), SHARED_FLOAT(1.0))
                                             : SHARED_FLOAT(0.0);
    return i.depthBegin * (SHARED_FLOAT(1.0) - share) + i.depthEnd * share;
}

/// A total order of different intervals: by time, triangle, and whatever else differs.
SHARED_FUNCTION bool comesBefore(MapInterval a, MapInterval b) {
    if (a.begin != b.begin) return a.begin < b.begin;
    if (a.id != b.id) return a.id < b.id;
    if (a.end != b.end) return a.end < b.end;
    if (a.depthBegin != b.depthBegin) return a.depthBegin < b.depthBegin;
    return a.depthEnd < b.depthEnd;
}

/// The order in which triangles are drawn, and intervals of one triangle follow each other.
SHARED_FUNCTION bool isDrawnBefore(MapInterval a, MapInterval b) {
    return a.id != b.id ? a.id < b.id : comesBefore(a, b);
}

/// By how much one distance must be less than another to be in front of it: more than interpolating them may be off.
/// What is as far away hides nothing, so that none of several that hide each other by rounding is lost.
#define HIDING_MARGIN SHARED_FLOAT(3.8147e-6)  // 2^-18, of the distance

/// How much farther `front` is than needed to hide `i` at u; negative where it hides it.
SHARED_FUNCTION float excessOver(MapInterval i, MapInterval front, float u) {
    float depth = depthAt(i, u);
    return depthAt(front, u) - depth + HIDING_MARGIN * depth;
}

/// The times (from, to) between which `front` hides `i`; none where they are no span. A function of the two alone.
SHARED_FUNCTION vec2 hiddenSpan(MapInterval i, MapInterval front) {
    float from = max(i.begin, front.begin), to = min(i.end, front.end);
    float first = excessOver(i, front, from), last = excessOver(i, front, to);
    float crossing = clamp(from + (to - from) * (first / (first - last)), from, to);
    if (first >= SHARED_FLOAT(0.0)) from = last >= SHARED_FLOAT(0.0) ? to : crossing;
    if (first < SHARED_FLOAT(0.0) && last > SHARED_FLOAT(0.0)) to = crossing;
    return vec2(from, to);
}

/// What is left of an interval from `begin` to `end`, both inside it; nothing where they are no span.
SHARED_FUNCTION MapInterval clippedTo(MapInterval i, float begin, float end) {
    if (!(begin < end)) return noInterval();
    MapInterval clipped = i;
    clipped.begin = begin;
    clipped.end = end;
    clipped.depthBegin = depthAt(i, begin);
    clipped.depthEnd = depthAt(i, end);
    return clipped;
}

/// The integral of the absolute value of what is linear from `first` to `last` over a span of time.
SHARED_FUNCTION float areaBetween(float first, float last, float length) {
    float a = abs(first), b = abs(last);
    bool oneSign =
        (first >= SHARED_FLOAT(0.0)) == (last >= SHARED_FLOAT(0.0)) || a == SHARED_FLOAT(0.0) || b == SHARED_FLOAT(0.0);
    float twice = oneSign ? a + b : (a * a + b * b) / (a + b);
    return SHARED_FLOAT(0.5) * length * twice;
}

/// One interval for two, `a` not beginning after `b`: from the first time to the last, linear between the distances
/// that the nearest of the two has there. It keeps the number of a triangle only where both have the same.
SHARED_FUNCTION MapInterval mergedOf(MapInterval a, MapInterval b) {
    MapInterval m;
    m.begin = a.begin;
    m.end = max(a.end, b.end);
    m.depthBegin = b.begin == a.begin ? min(a.depthBegin, b.depthBegin) : a.depthBegin;
    m.depthEnd = a.end == b.end ? min(a.depthEnd, b.depthEnd) : (a.end > b.end ? a.depthEnd : b.depthEnd);
    m.id = a.id == b.id ? a.id : NO_INTERVAL_ID;
    return m;
}

/// Area between what is merged and one of the two over a span in which that one is the nearest.
SHARED_FUNCTION float areaOver(MapInterval merged, MapInterval nearest, float from, float to) {
    if (!(to > from)) return SHARED_FLOAT(0.0);
    return areaBetween(depthAt(merged, from) - depthAt(nearest, from), depthAt(merged, to) - depthAt(nearest, to),
                       to - from);
}

/// The error of merging, distance times u: the area between the merged interval and the nearest of the two. Where
/// there was neither, the whole distance counts as an error.
SHARED_FUNCTION float mergingError(MapInterval a, MapInterval b) {
    MapInterval m = mergedOf(a, b);
    if (b.begin >= a.end) {
        float gap = SHARED_FLOAT(0.5) * (depthAt(m, a.end) + depthAt(m, b.begin)) * (b.begin - a.end);
        return areaOver(m, a, a.begin, a.end) + gap + areaOver(m, b, b.begin, b.end);
    }
    float from = b.begin, to = min(a.end, b.end);
    float first = depthAt(a, from) - depthAt(b, from), last = depthAt(a, to) - depthAt(b, to);
    float error = areaOver(m, a, a.begin, from);
    if (a.end > to) error += areaOver(m, a, to, a.end);
    if (b.end > to) error += areaOver(m, b, to, b.end);
    if (first * last < SHARED_FLOAT(0.0)) {
        float cross = clamp(from + (to - from) * (first / (first - last)), from, to);
        MapInterval before = a, behind = b;
        if (first > SHARED_FLOAT(0.0)) {
            before = b;
            behind = a;
        }
        return error + areaOver(m, before, from, cross) + areaOver(m, behind, cross, to);
    }
    if (first + last > SHARED_FLOAT(0.0)) return error + areaOver(m, b, from, to);
    return error + areaOver(m, a, from, to);
}

SHARED_END
