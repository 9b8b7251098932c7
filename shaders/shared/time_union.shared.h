#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// The interval that a mean is taken over, in ticks: times are whole numbers of them, which floats hold and add exactly,
// so that no sum depends on the order of its terms.
#define TICKS SHARED_FLOAT(16777216.0)
// Where a free place of a union begins: beyond all ticks.
#define TIME_UNION_FREE SHARED_FLOAT(67108864.0)

SHARED_BEGIN

/// A union of at most eight intervals that neither overlap nor touch, in no order, with whole ends in [0, TICKS].
struct TimeUnion {
    vec4 begin0, begin1, end0, end1;  // a free place begins at TIME_UNION_FREE or later and ends at -1
    float covered;                    // of all, in ticks
    uint full;                        // 1: an interval found no place; the union lacks it
};

SHARED_FUNCTION TimeUnion emptyTimeUnion() {
    return TimeUnion(vec4(TIME_UNION_FREE), vec4(TIME_UNION_FREE), vec4(SHARED_FLOAT(-1.0)), vec4(SHARED_FLOAT(-1.0)),
                     SHARED_FLOAT(0.0), 0u);
}

SHARED_FUNCTION float leastOf(vec4 v) { return min(min(v.x, v.y), min(v.z, v.w)); }
SHARED_FUNCTION float mostOf(vec4 v) { return max(max(v.x, v.y), max(v.z, v.w)); }

/// How many intervals it has.
SHARED_FUNCTION float intervalsOf(TimeUnion u) {
    vec4 isUsed = step(u.begin0, vec4(TICKS)) + step(u.begin1, vec4(TICKS));
    return isUsed.x + isUsed.y + isUsed.z + isUsed.w;
}

/// Which place of four an interval is put in, as 1 among zeros: the first free one, none if `wanted` is 0.
SHARED_FUNCTION vec4 firstFreeOf(vec4 begin, float wanted) {
    vec4 isFree = step(vec4(TIME_UNION_FREE), begin);
    float x = isFree.x, y = isFree.y * (SHARED_FLOAT(1.0) - x), z = isFree.z * (SHARED_FLOAT(1.0) - x - y);
    return wanted * vec4(x, y, z, isFree.w * (SHARED_FLOAT(1.0) - x - y - z));
}

/// The union with one more interval, whole ends in [0, TICKS]; an empty one (end <= begin) adds nothing. Intervals that
/// it overlaps or touches become one with it, so that the union of any intervals is the same in whatever order they
/// come, as long as it never is full. If eight others are left already, `full` is set. Exact.
SHARED_FUNCTION TimeUnion withInterval(TimeUnion u, float begin, float end) {
    if (!(begin < end)) return u;
    const float one = SHARED_FLOAT(1.0);
    vec4 met0 = step(u.begin0, vec4(end)) * step(vec4(begin), u.end0);
    vec4 met1 = step(u.begin1, vec4(end)) * step(vec4(begin), u.end1);
    float covered = u.covered - dot(met0, u.end0 - u.begin0) - dot(met1, u.end1 - u.begin1);
    begin = min(begin, min(leastOf(u.begin0 + (one - met0) * TIME_UNION_FREE),
                           leastOf(u.begin1 + (one - met1) * TIME_UNION_FREE)));
    end = max(end, max(mostOf(u.end0 * met0), mostOf(u.end1 * met1)));
    u.begin0 += met0 * TIME_UNION_FREE;
    u.begin1 += met1 * TIME_UNION_FREE;
    u.end0 = u.end0 * (one - met0) - met0;
    u.end1 = u.end1 * (one - met1) - met1;
    u.covered = covered + (end - begin);
    vec4 put0 = firstFreeOf(u.begin0, one);
    vec4 put1 = firstFreeOf(u.begin1, one - (put0.x + put0.y + put0.z + put0.w));
    if (put0.x + put0.y + put0.z + put0.w + put1.x + put1.y + put1.z + put1.w == SHARED_FLOAT(0.0)) u.full = 1u;
    u.begin0 = u.begin0 * (one - put0) + begin * put0;
    u.begin1 = u.begin1 * (one - put1) + begin * put1;
    u.end0 = u.end0 * (one - put0) + end * put0;
    u.end1 = u.end1 * (one - put1) + end * put1;
    return u;
}

SHARED_END
