#ifdef __cplusplus
#pragma once
#endif
#include "shared/map_interval.shared.h"

// The list of intervals of one texel. Whoever includes this has declared
//     MapInterval loadInterval(uint place)
//     float loadBegin(uint place)              its begin alone
//     void storeInterval(uint place, MapInterval i)
// before, in the same namespace; the latter only for compressIntervals. Places `first` up to `last`, not included, are
// the list. Software renderers break off the loops of an invocation after 65,535 rounds in all: none here goes over all
// pairs of a list.

SHARED_BEGIN

/// How many of the list come before the one at `place`, by time: its place in order, whatever order the list is in.
SHARED_FUNCTION uint rankByTime(uint first, uint last, uint place) {
    MapInterval i = loadInterval(place);
    uint rank = 0u;
    for (uint other = first; other < last; ++other) {
        float begin = loadBegin(other);
        if (begin < i.begin) ++rank;
        // A loop of one round where a branch would do (lib/only_if.glsl).
        for (int rounds = begin == i.begin && other != place ? 1 : 0; rounds > 0; --rounds) {
            MapInterval o = loadInterval(other);
            if (comesBefore(o, i) || (!comesBefore(i, o) && other < place)) ++rank;
        }
    }
    return rank;
}

/// The same in the order in which triangles are drawn.
SHARED_FUNCTION uint rankAsDrawn(uint first, uint last, uint place) {
    MapInterval i = loadInterval(place);
    uint rank = 0u;
    for (uint other = first; other < last; ++other) {
        MapInterval o = loadInterval(other);
        if (isDrawnBefore(o, i) || (!isDrawnBefore(i, o) && other < place)) ++rank;
    }
    return rank;
}

/// The part of the interval at `place` from the first to the last time at which no other of the list hides it; nothing
/// where it is hidden all the time. Steps from one that hides its beginning to the next, and likewise from its end.
/// What more than MAX_HIDING_ROUNDS rows hide is left longer than it might be, which changes no nearest distance.
#define MAX_HIDING_ROUNDS 32
SHARED_FUNCTION MapInterval visiblePart(uint first, uint last, uint place) {
    MapInterval i = loadInterval(place);
    float begin = i.begin, end = i.end;
    bool moved = last - first > 1u;
    for (int rounds = 0; rounds < MAX_HIDING_ROUNDS && moved && begin < end; ++rounds) {
        float beginBefore = begin, endBefore = end;
        for (uint other = first; other < last; ++other) {
            vec2 hidden = hiddenSpan(i, loadInterval(other));  // by itself as well, which is never
            if (hidden.x <= begin && hidden.y > begin) begin = hidden.y;
            if (hidden.x < end && hidden.y >= end) end = hidden.x;
        }
        moved = begin > beginBefore || end < endBefore;
    }
    if (begin == i.begin && end == i.end) return i;
    return clippedTo(i, begin, end);
}

/// Merges the two neighbours (by time) of the `count` intervals from `first` on whose error is least, of equal ones the
/// first; returns that error. At least two.
SHARED_FUNCTION float mergeLeast(uint first, uint count) {
    uint best = first;
    float least = SHARED_FLOAT(3e38);
    MapInterval a = loadInterval(first);
    for (uint place = first; place + 1u < first + count; ++place) {
        MapInterval b = loadInterval(place + 1u);
        float error = mergingError(a, b);
        if (error < least) {
            least = error;
            best = place;
        }
        a = b;
    }
    storeInterval(best, mergedOf(loadInterval(best), loadInterval(best + 1u)));
    for (uint place = best + 1u; place + 1u < first + count; ++place) storeInterval(place, loadInterval(place + 1u));
    return least;
}

/// Inserts the intervals from `from` up to `last`, not included, into a list of at most `capacity` (at least 1) that
/// begins at `first`, sorted by time, and that holds what was before `from`; two are merged whenever there is one too
/// many. The rest becomes noInterval(). Returns the sum of the errors: the area between the nearest distances before
/// and after is at most that, where there is nothing at a time the whole distance being counted.
SHARED_FUNCTION float compressIntervals(uint first, uint from, uint last, uint capacity) {
    float error = SHARED_FLOAT(0.0);
    uint kept = min(from - first, capacity);
    for (uint next = from; next < last; ++next) {
        MapInterval inserted = loadInterval(next);
        if (first + kept < next) storeInterval(next, noInterval());
        uint place = first + kept;
        for (; place > first; --place) {
            MapInterval before = loadInterval(place - 1u);
            if (!comesBefore(inserted, before)) break;
            storeInterval(place, before);
        }
        storeInterval(place, inserted);
        ++kept;
        if (kept > capacity) {
            error += mergeLeast(first, kept);
            --kept;
            storeInterval(first + kept, noInterval());
        }
    }
    return error;
}

SHARED_END
