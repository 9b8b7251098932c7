// The share of an interval of the shutter during which a receiver sees the light: 1 - |union of the times at which a
// candidate shadows it| (ours; docs/numerics.md, "Integrals over time"). Casters and receiver move; the times are the
// roots of polynomials, and nothing is sampled.
//
// MOTION: what moves (shared/time_integral.shared.h). VIEW_CANDIDATES: how many instead, all of those that a lit
// receiver is solved against. VIEW_ERROR: how far the mean may be off. DYNAMIC_TRIANGLES, STATIC_TRIANGLES,
// STATIC_CASTERS_TRAVEL: as in lib/candidate_lists.glsl. CUTOUTS: as in lib/cutouts.glsl.
#include "lib/candidate_lists.glsl"
#include "lib/lookup.glsl"
#include "lib/only_if.glsl"
#include "shared/shutter_response.shared.h"
#include "techniques/integral/cells.glsl"
#include "techniques/integral/cut_outs.glsl"

float solved = 0.0;  // candidates of this sample, once for each piece of its way
float doubt = 0.0;   // ticks, whole

bool isCounting = true;  // once for the whole way, not again for its halves

// Nothing that is still to come changes it. Lists have no order: what is shown of them stops nowhere before their end.
bool isSettled(TimeUnion dark, vec2 wanted) {
#if defined(VIEW_CANDIDATES) || defined(VIEW_ERROR)
    return false;
#else
    return dark.full != 0u || dark.covered >= wanted.y - wanted.x;
#endif
}

MotionPiece motionPiece(ReceiverSegment s, VertexMotion v, float begin, float end) {
    float u0 = timeOf(s, begin), u1 = timeOf(s, end);
    vec3 from = mix(s.open, s.close, begin / TICKS), to = mix(s.open, s.close, end / TICKS);
    SeenVertices open = seenVertices(v, from, u0), close = seenVertices(v, to, u1);
    return MotionPiece(mix(s.toOpen, s.toClose, begin / TICKS), mix(s.toOpen, s.toClose, end / TICKS), open.v0, open.v1,
                       open.v2, close.v0, close.v1, close.v2, s.clearance);
}

// The union with the shadows of the candidates of one cell.
TimeUnion withCell(TimeUnion dark, ReceiverSegment s, CellPiece p, vec2 wanted, usamplerBuffer candidates, ivec2 span,
                   uint box, bool mayMove) {
    const int together = int(CANDIDATES_TOGETHER);  // as many as a vector holds
    const uint all = (1u << CANDIDATES_TOGETHER) - 1u;
    int first = span.x, last = span.y;
    int entry = first & ~(together - 1);
    uvec4 ids = uvec4(0u);
    uint waiting = 0u;  // of those, which are still to be solved
    PieceTicks ticks = PieceTicks(p.begin, p.end, wanted.x, wanted.y);
    while (!isSettled(dark, wanted)) {
        while (waiting == 0u && entry < last) {
            int texel = int(uint(entry) / CANDIDATES_TOGETHER * 2u);
            waiting = reachingOf(texelFetch(candidates, texel), box) & (all << uint(max(first - entry, 0))) &
                      (all >> uint(max(entry + together - last, 0)));
            ids = texelFetch(candidates, texel + 1);
            waiting &= ~maskOf(equal(ids & uvec4(~CANDIDATE_MOVES), uvec4(s.triangle)));
            entry += together;
        }
        if (waiting == 0u) break;
        solved += 1.0;
        uint id = (waiting & 1u) != 0u ? ids.x : (waiting & 2u) != 0u ? ids.y : (waiting & 4u) != 0u ? ids.z : ids.w;
        bool moves = mayMove && (id & CANDIDATE_MOVES) != 0u;
        id &= ~CANDIDATE_MOVES;
        MotionPiece m = motionPiece(s, fetchMotion(trianglePositions, id, moves), p.begin, p.end);
#ifndef VIEW_CANDIDATES
#ifdef CUTOUTS
        float missed = 0.0;
        bool cut = isCutOut(id);
        TimeUnion shadow = emptyTimeUnion();
        if (!cut) shadow = dark;
        shadow = withShadow(shadow, m, ticks, MOTION);
        if (cut)
            dark = withCutOut(dark, shadow, id, m, ticks, missed);
        else
            dark = shadow;
#else
        dark = withShadow(dark, m, ticks, MOTION);
#endif
#endif
#ifdef VIEW_ERROR
        if (isCounting) doubt += ceil(shadowDoubt(m, MOTION) * (p.end - p.begin));
#ifdef CUTOUTS
        if (isCounting) doubt += missed;
#endif
#endif
        waiting &= waiting - 1u;
    }
    return dark;
}

// The union with the shadows of all candidates, as far as they lie in the ticks `wanted`. The pieces are those of the
// whole way whatever is wanted.
TimeUnion withLists(TimeUnion dark, ReceiverSegment s, vec2 wanted, usamplerBuffer offsets, usamplerBuffer candidates,
                    uint side, uint bucketCount, bool mayMove) {
    float begin = s.first;
    ivec2 cell = ivec2(floor(onMap(mapBlossom(s, begin, begin)) * float(side)));
    uint bucket = min(uint(timeOf(s, begin) * float(bucketCount)), bucketCount - 1u);
    int left = 4 * int(side) + 2 * int(bucketCount);  // no way is longer, whatever is rounded
    while (begin < min(s.last, wanted.y) && !isSettled(dark, wanted) && left > 0) {
        --left;
        float closes = (float(bucket + 1u) / float(bucketCount) - s.u0) / max(s.u1 - s.u0, 1e-12) * TICKS;
        float end = bucket + 1u < bucketCount ? clamp(floor(closes + 0.5), begin, s.last) : s.last;
        CellPiece p = pieceIn(s, cell, begin, end, float(side));
        if (p.end > max(p.begin, wanted.x)) {
            ivec2 inside = clamp(cell, ivec2(0), ivec2(side) - 1);
            ivec2 span = listSpan(offsets, int((bucket * side + uint(inside.y)) * side) + inside.x);
            dark = withCell(dark, s, p, wanted, candidates, span, boxOf(p, float(side)), mayMove);
        }
        begin = p.end;
        cell += p.onwards;
        if (p.onwards == ivec2(0)) bucket = min(bucket + 1u, bucketCount - 1u);
    }
    return dark;
}

TimeUnion darkTimes(ReceiverSegment s, vec2 wanted) {
    TimeUnion dark = emptyTimeUnion();
    ONLY_IF(s.untested.covered > 0.0) {
        TimeUnion away = s.untested;
        for (int i = 0; i < 4; ++i) {
            dark = withInterval(dark, max(away.begin0[i], wanted.x), min(away.end0[i], wanted.y));
            dark = withInterval(dark, max(away.begin1[i], wanted.x), min(away.end1[i], wanted.y));
        }
    }
#ifdef DYNAMIC_TRIANGLES
    dark = withLists(dark, s, wanted, dynamicOffsets, dynamicCandidates, dynamicSide, buckets, true);
#endif
#ifdef STATIC_TRIANGLES
    dark = withLists(dark, s, wanted, staticOffsets, staticCandidates, staticSide, 1u, staticCastersTravel);
#endif
    return dark;
}

// The exposure from the segment's begin until a tick; whole numbers, so that sums are exact.
float exposureUntil(ReceiverSegment s, float tick) {
    if (frame.response == SHUTTER_BOX || s.u1 <= s.u0) return tick;
    float begin = shutterExposure(frame.response, frame.responseWidth, s.u0);
    float whole = shutterExposure(frame.response, frame.responseWidth, s.u1) - begin;
    float until = shutterExposure(frame.response, frame.responseWidth, timeOf(s, tick)) - begin;
    return floor(clamp(until / whole, 0.0, 1.0) * TICKS + 0.5);
}

// An exposure, and the integrals over it of the time and of its square, as shares of the segment.
vec3 momentsOf(ReceiverSegment s, float begin, float end) {
    float exposure = max(exposureUntil(s, end) - exposureUntil(s, begin), 0.0);
    float middle = 0.5 * (begin + end) / TICKS, length = (end - begin) / TICKS;
    return exposure * vec3(1.0, middle, middle * middle + length * length / 12.0);
}

vec3 momentsOf(ReceiverSegment s, TimeUnion u, float from, float to) {
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        float a = max(u.begin0[i], from), b = min(u.end0[i], to), c = max(u.begin1[i], from), d = min(u.end1[i], to);
        if (a < b) sum += momentsOf(s, a, b);
        if (c < d) sum += momentsOf(s, c, d);
    }
    return sum;
}

// Of the part of a union between two ticks.
float exposureOf(ReceiverSegment s, TimeUnion u, float from, float to) {
    if (frame.response == SHUTTER_BOX && from <= 0.0 && to >= TICKS) return u.covered;
    return momentsOf(s, u, from, to).x;
}

// The exposure during which the receiver sees the light (x), and that during which it is tested (y), as shares of the
// segment's; and of the former the moments. Where the union is full the interval is halved and the candidates are read
// again: nothing is merged, and no order matters.
vec4 exposuresOver(ReceiverSegment s) {
    float lit = 0.0;
    vec2 moments = vec2(0.0);
    vec2 wanted = vec2(s.first, s.last);
    while (wanted.x < s.last) {
        TimeUnion dark = darkTimes(s, wanted);
        isCounting = false;
        float width = wanted.y - wanted.x;
        if (dark.full != 0u) {
            wanted.y = wanted.x + floor(0.5 * width);
            continue;
        }
        lit += exposureUntil(s, wanted.y) - exposureUntil(s, wanted.x) - exposureOf(s, dark, wanted.x, wanted.y);
#ifdef SOLVES_INTERVALS
        moments += momentsOf(s, wanted.x, wanted.y).yz;
        ONLY_IF(dark.covered > 0.0) moments -= momentsOf(s, dark, wanted.x, wanted.y).yz;
#endif
        if (intervalsOf(dark) <= 3.0) width *= 2.0;
        wanted = vec2(wanted.y, min(s.last, wanted.y + width));
    }
    // A driver may bound the rounds of loops (65,535 here): then the mean is that of what was integrated.
    float until = min(wanted.x, s.last);
    doubt += s.last - until;
    float tested = exposureUntil(s, until) - exposureUntil(s, s.first) - exposureOf(s, s.untested, s.first, until);
    return vec4(lit, tested, moments) / TICKS;
}

float litOver(MovingTriangle t, Receiver r, float u0, float u1) {
    vec2 exposures = exposuresOver(segmentOn(t, r, u0, u1)).xy;
    return exposures.y > 0.0 ? exposures.x / exposures.y : 1.0;
}

#ifdef SOLVES_INTERVALS
float exposureUntil(float u) { return shutterExposure(frame.response, frame.responseWidth, u); }

// Of a segment that is a part of another, from `begin` to `end` of it: moments as of the other.
vec4 asPart(vec4 e, float begin, float end) {
    float length = end - begin;
    e.w = begin * begin * e.x + 2.0 * begin * length * e.z + length * length * e.w;
    e.z = begin * e.x + length * e.z;
    return e;
}

vec4 litAlong(MovingTriangle t, uint id, vec2 position, float u0, float u1) {
    Receiver open = receiverOnRay(t, id, position, u0), last = receiverOnRay(t, id, position, u1);
    int chords = chordsOf(t, open, last, position);
    float whole = exposureUntil(u1) - exposureUntil(u0);
    vec4 sum = vec4(0.0);
    for (int i = 1; i <= chords; ++i) {
        Receiver close = last;
        ONLY_IF(i < chords) close = receiverOnRay(t, id, position, mix(u0, u1, float(i) / float(chords)));
        float weight = (exposureUntil(close.time) - exposureUntil(open.time)) / whole;
        sum += weight * asPart(exposuresOver(segmentAlong(t, open, close)), float(i - 1) / float(chords),
                               float(i) / float(chords));
        open = close;
    }
    if (sum.y <= 0.0) return vec4(1.0, 0.0, 0.5, 0.25);
    vec2 times = sum.x > 0.0 ? clamp(sum.zw / sum.x, 0.0, 1.0) : vec2(0.5, 0.25);
    return vec4(clamp(sum.x / sum.y, 0.0, 1.0), min(sum.y, 1.0), times);
}
#endif

#if defined(VIEW_CANDIDATES) || defined(VIEW_ERROR)
uniform float share;  // of a sample in its pixel
layout(location = 0) out float outputValue;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
    outputValue = 0.0;
    if (id == NO_TRIANGLE) return;
    MovingTriangle t = fetchTriangle(id);
    Receiver r = receiverOf(t, id, pixel, stratum);
    if (!facesLight(r)) return;
#ifdef FOOTPRINT_SHUTTER
    litOver(t, r, frame.timeBase, frame.timeBase + float(frame.strata) * frame.timeScale);
#else
    float begin = frame.timeBase + float(stratum) * frame.timeScale;
    litOver(t, r, begin, begin + frame.timeScale);
#endif
#ifdef VIEW_ERROR
    outputValue = min(1.0, doubt / TICKS) * share;
#else
    outputValue = solved * share;
#endif
}
#else
#include "lib/lookup_main.glsl"
#endif
