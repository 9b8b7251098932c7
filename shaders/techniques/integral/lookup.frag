// The share of an interval of the shutter during which a receiver sees the light: 1 - |union of the times at which a
// candidate shadows it| (ours; docs/numerics.md, "Integrals over time"). Casters and receiver move; the times are the
// roots of polynomials, and nothing is sampled.
//
// MOTION: what moves (shared/time_integral.shared.h). VIEW_CANDIDATES: how many instead, all of those that a lit
// receiver is solved against. VIEW_ERROR: how far the mean may be off. DYNAMIC_TRIANGLES, STATIC_TRIANGLES,
// STATIC_CASTERS_TRAVEL: as in lib/candidate_lists.glsl. CUTOUTS: as in lib/cutouts.glsl.
#include "lib/candidate_lists.glsl"
#include "lib/cutout_times.glsl"
#include "lib/lookup.glsl"
#include "lib/map_way.glsl"
#include "lib/segment_exposure.glsl"

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

// What candidates' bounds are compared with.
uint boxOf(CellPiece p, float side) {
    vec2 a = onMap(p.open) * side, b = onMap(p.close) * side;
    vec2 low = min(a, b), high = max(a, b);
#ifdef LIGHT_ORTHOGRAPHIC
    low = min(low, p.middle.xy * side);
    high = max(high, p.middle.xy * side);
#endif
    ivec2 cell = clamp(p.cell, ivec2(0), ivec2(side) - 1);
    return packReceiverBox(low - vec2(cell), high - vec2(cell), depthStep(max(p.open.z, p.close.z), leastDepth()));
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
        float missed = 0.0;
#ifndef VIEW_CANDIDATES
        dark = withCaster(dark, id, m, ticks, missed);
#endif
#ifdef VIEW_ERROR
        if (isCounting) doubt += ceil(shadowDoubt(m, MOTION) * (p.end - p.begin)) + missed;
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
        CellPiece p = pieceIn(s, cell, vec2(cell) / float(side), vec2(cell + 1) / float(side), begin, end);
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
        dark = withUnion(dark, s.untested, wanted.x, wanted.y);
    }
#ifdef DYNAMIC_TRIANGLES
    dark = withLists(dark, s, wanted, dynamicOffsets, dynamicCandidates, dynamicSide, buckets, true);
#endif
#ifdef STATIC_TRIANGLES
    dark = withLists(dark, s, wanted, staticOffsets, staticCandidates, staticSide, 1u, staticCastersTravel);
#endif
    return dark;
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
// Width of a pixel at a place, in world units.
float pixelWidthAt(vec3 place, float u) {
    vec3 view = inCameraAt(place, place, u);
    mat4 m = cameraView.viewFromWorldOpen;
    vec3 change = vec3(m[0].x, m[1].x, m[2].x) - view.x / view.z * vec3(m[0].z, m[1].z, m[2].z);
    return abs(view.z) / (length(change) * cameraView.size.x);
}

// 1/256 of a pixel; a short way, as large pixels see it, is held to a share of itself.
float allowedOffWay(Receiver open, Receiver close) {
    return min(pixelWidthAt(close.position, close.time) / 256.0, length(close.position - open.position) / 16384.0);
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
