// The intervals of one moving triangle at one texel: one for each time that it covers the texel's centre, at the exact
// times (Palmér 2011, section 2.1: where v(t) > 0). Drawn twice by the same program: first to count, then (filling) to
// write.
//
// Where the triangle turns or deforms its distance is not linear in u. AS_PUBLISHED: each interval is cut into
// `depth_pieces` of equal length (figure 2.6). Else it is halved until the distance is within `depth_error` of linear
// at three times of each part (chapter 5, adaptive depth sampling).
//
// STATIC_TRIANGLES: what is wholly behind the map of what stands still is left out, as nothing there is lit.
#include "lib/cell_lists.glsl"
#include "lib/covering_triangle.glsl"
#include "lib/only_if.glsl"
#include "lib/settings.glsl"
#include "techniques/intervals/bindings.shared.h"

layout(std430, binding = INTERVAL_TIMES_BINDING) writeonly buffer IntervalTimes { vec2 intervalTimes[]; };
layout(std430, binding = INTERVAL_DEPTHS_BINDING) writeonly buffer IntervalDepths { vec2 intervalDepths[]; };
layout(std430, binding = INTERVAL_IDS_BINDING) writeonly buffer IntervalIds { uint intervalIds[]; };
layout(std430, binding = INTERVAL_COUNTS_BINDING) buffer IntervalCounts { uint bentParts; };
uniform uint filling;
#ifdef STATIC_TRIANGLES
uniform sampler2DArray staticMap;
#endif

const int MAX_PARTS = 64, MAX_HALVINGS = 6;

struct Part {
    float begin, end, depthBegin, depthEnd;
};

bool bendsAt(SeenTriangle t, Part p, float share) {
    float depth = casterDistance(t, mix(p.begin, p.end, share));
    return abs(depth - mix(p.depthBegin, p.depthEnd, share)) > setting.depth_error * texelWidth(depth);
}

bool bends(SeenTriangle t, Part p) { return bendsAt(t, p, 0.5) || bendsAt(t, p, 0.25) || bendsAt(t, p, 0.75); }

// The part that begins there, of an interval that lasts until `end`.
Part partFrom(SeenTriangle t, float begin, float depth, float end, float length) {
#ifdef AS_PUBLISHED
    float partEnd = begin + 1.5 * length < end ? begin + length : end;
    return Part(begin, partEnd, depth, casterDistance(t, partEnd));
#else
    Part p = Part(begin, end, depth, casterDistance(t, end));
    for (int i = nonTranslating != 0u ? 0 : MAX_HALVINGS; i < MAX_HALVINGS && bends(t, p); ++i) {
        p.end = 0.5 * (p.begin + p.end);
        p.depthEnd = casterDistance(t, p.end);
    }
    return p;
#endif
}

void put(uint cell, Part p) {
    uint slot = listSlot(cell);
    ONLY_IF(filling != 0u && slot < uint(intervalTimes.length())) {
        intervalTimes[slot] = vec2(p.begin, p.end);
        intervalDepths[slot] = vec2(p.depthBegin, p.depthEnd);
        intervalIds[slot] = triangleId;
    }
}

void main() {
    SeenTriangle t = seenTriangle(texelCentre());
    precise EdgeQuadratics e = quadraticsOf(t);
    CoverageIntervals intervals = intervalsOfTranslation(e);
    ONLY_IF(nonTranslating != 0u) intervals = intervalsOf(e);
    uint cell = uint(gl_FragCoord.y) * frame.mapWidth + uint(gl_FragCoord.x);
    float behind = 1e30;
#ifdef STATIC_TRIANGLES
    ONLY_IF(intervals.count > 0) behind = mapDistance(texelFetch(staticMap, ivec3(gl_FragCoord.xy, 0), 0).x);
#endif
    for (int i = 0; i < intervals.count; ++i) {
        float begin = intervals.begins[i], end = intervals.ends[i], depth = casterDistance(t, begin);
        float length = (end - begin) / (nonTranslating != 0u ? setting.depth_pieces : 1.0);
        for (int part = 0; part < MAX_PARTS && begin < end; ++part) {
            precise Part p = partFrom(t, begin, depth, end, length);
            ONLY_IF(part == MAX_PARTS - 1 && p.end < end) {
                p.end = end;
                p.depthEnd = casterDistance(t, end);
            }
#ifndef AS_PUBLISHED
            ONLY_IF(nonTranslating != 0u && filling != 0u && bends(t, p)) atomicAdd(bentParts, 1u);
#endif
            ONLY_IF(min(p.depthBegin, p.depthEnd) <= behind) put(cell, p);
            begin = p.end;
            depth = p.depthEnd;
        }
    }
}
