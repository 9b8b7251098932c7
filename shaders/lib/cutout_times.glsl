// The times at which a triangle shadows a receiver, once its alpha is cut out of it.
//
// MOTION: what moves (shared/time_integral.shared.h).
#include "lib/only_if.glsl"
#include "lib/segment_test.glsl"
#include "shared/time_integral.shared.h"

#ifdef CUTOUTS
// What alpha cuts out has no edges to solve for: of the times at which a triangle is met, so many are looked at.
const float testsOfGap = MOTION == 0u ? 1.0 : 16.0;
const int halvings = 10;  // of the time between two that differ

bool coversAtTick(uint id, MotionPiece m, PieceTicks ticks, float tick) {
    float t = clamp((tick - ticks.begin) / max(ticks.end - ticks.begin, 1.0), 0.0, 1.0);
    SeenVertices seen = SeenVertices(mix(m.open0, m.close0, t), mix(m.open1, m.close1, t), mix(m.open2, m.close2, t));
    return coversLine(id, seen, mix(m.lightOpen, m.lightClose, t));
}

// The union with the times from `begin` to `end`, during which the triangle is met, at which it covers; what may
// come and go between two looks is added to `missed`, in ticks.
TimeUnion withCovered(TimeUnion dark, uint id, MotionPiece m, PieceTicks ticks, float begin, float end,
                      inout float missed) {
    float step = (end - begin) / testsOfGap, from = begin, before = begin;
    bool covered = false;
    for (float k = 0.0; k <= testsOfGap; k += 1.0) {
        bool last = k == testsOfGap;
        float now = last ? end : begin + (k + 0.5) * step;
        bool covers = last ? !covered : coversAtTick(id, m, ticks, now);
        ONLY_IF(covers != covered) {
            float low = before, high = now;
            for (int i = last || k == 0.0 ? halvings : 0; i < halvings; ++i) {
                float middle = 0.5 * (low + high);
                bool same = coversAtTick(id, m, ticks, middle) == covered;
                low = same ? middle : low;
                high = same ? high : middle;
            }
            float change = k == 0.0 ? begin : last ? end : floor(high + 0.5);
            ONLY_IF(covered) dark = withInterval(dark, from, change);
            from = change;
            covered = covers;
        }
        before = now;
    }
    missed += MOTION == 0u ? 0.0 : ceil(step);
    return dark;
}

// The union with what is left of a triangle's shadow, `met`, once its alpha is cut out of it.
TimeUnion withCutOut(TimeUnion dark, TimeUnion met, uint id, MotionPiece m, PieceTicks ticks, inout float missed) {
    for (int i = 0; i < 4; ++i) {
        ONLY_IF(met.begin0[i] < met.end0[i]) {
            dark = withCovered(dark, id, m, ticks, met.begin0[i], met.end0[i], missed);
        }
        ONLY_IF(met.begin1[i] < met.end1[i]) {
            dark = withCovered(dark, id, m, ticks, met.begin1[i], met.end1[i], missed);
        }
    }
    if (met.full != 0u) dark.full = 1u;
    return dark;
}
#endif

// The union with the shadow of triangle `id`, whose motion is `m`; what alpha may hide between two looks is added to
// `missed`, in ticks.
TimeUnion withCaster(TimeUnion dark, uint id, MotionPiece m, PieceTicks ticks, inout float missed) {
#ifdef CUTOUTS
    bool cut = isCutOut(id);
    TimeUnion shadow = emptyTimeUnion();
    if (!cut) shadow = dark;
    shadow = withShadow(shadow, m, ticks, MOTION);
    if (cut)
        dark = withCutOut(dark, shadow, id, m, ticks, missed);
    else
        dark = shadow;
    return dark;
#else
    return withShadow(dark, m, ticks, MOTION);
#endif
}
