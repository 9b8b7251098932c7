// For how long of an interval a receiver is lit: its depth is put among those of the texel's list, and what is nearer
// leaves the rest of the time lit (Palmér 2011, section 2.3.1). A receiver that moves on the map is followed from texel
// to texel, in pieces over which the depth that is compared is linear. AS_PUBLISHED: where it begins and ends in
// different texels its interval is sampled at points (section 2.3.2), in the middle of equal parts.
#define MOTION MOTION_ALL
#include "lib/cutout_times.glsl"
#include "lib/map_way.glsl"
#include "lib/segment_exposure.glsl"

const int HALVINGS = 6;
const float POINTS = 1024.0;  // an interval is sampled at no more

float reached = 0.0;  // the tick until which it was followed: a driver may bound the rounds of all loops

// A part of a receiver's way, and what entries of a texel are compared with at both ends.
struct ComparedPart {
    float begin, end;  // ticks
    float depthBegin, depthEnd;
};

// `path` is of the triangle's first vertex.
PlaneInView planeAt(ReceiverSegment s, PathInView path, float tick) {
    float u = timeOf(s, tick);
    vec3 v = mapBlossom(s, tick, tick);
    PlaneInView p = planeThrough(path, v, u);
#ifndef AS_PUBLISHED
    // A chord leaves the triangle's plane, by less than allowedOffWay but where the light sees the plane edge-on.
    float off = dot(p.normal, v - mix(path.open, path.close, u)) / p.towards;
    if (abs(off) < texelWidth(p.depth)) p.depth -= off;
#endif
    return p;
}

float comparedAt(ComparedPart p, float tick) {
    return mix(p.depthBegin, p.depthEnd, clamp((tick - p.begin) / max(p.end - p.begin, 1.0), 0.0, 1.0));
}

// The times between two ticks at which what is linear from `first` to `last` is negative; none where it ends first.
vec2 negativeSpan(float from, float to, float first, float last) {
    if (first >= 0.0 && last >= 0.0) return vec2(from, from);
    float crossing = floor(mix(from, to, clamp(first / (first - last), 0.0, 1.0)) + 0.5);
    return vec2(first < 0.0 ? from : crossing, last < 0.0 ? to : crossing);
}

#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
float tickAt(ReceiverSegment s, float u) {
    return clamp(floor((u - s.u0) / max(s.u1 - s.u0, 1e-12) * TICKS + 0.5), 0.0, TICKS);
}

#ifdef CUTOUTS
// The union with what a triangle that is cut out by its alpha covers of a span: looked at in the middle of equal parts.
TimeUnion withCovered(TimeUnion dark, ReceiverSegment s, uint id, vec2 span) {
    const float looks = 16.0;
    float length = (span.y - span.x) / looks;
    for (float k = 0.0; k < looks && length > 0.0; k += 1.0) {
        float tick = span.x + (k + 0.5) * length;
        bool covers = cutoutCoversLight(id, onMap(mapBlossom(s, tick, tick)), timeOf(s, tick));
        float from = floor(span.x + k * length + 0.5), to = floor(span.x + (k + 1.0) * length + 0.5);
        ONLY_IF(covers) dark = withInterval(dark, from, to);
    }
    return dark;
}
#endif

// The union with the times between two ticks at which another triangle's interval in this texel is nearer.
TimeUnion withList(TimeUnion dark, ReceiverSegment s, ComparedPart p, ivec2 texel, vec2 wanted) {
    ivec2 span = listSpan(intervalOffsets, listNumber(texel));
    float first = timeOf(s, wanted.x), last = timeOf(s, wanted.y);
    bool isSettled = false;
    for (int i = span.x; i < span.y && !isSettled; ++i) {
        vec2 times = texelFetch(intervalTimes, i).xy;
        if (times.x > last) break;
        uint id = texelFetch(intervalIds, i).x;
        ONLY_IF(times.y >= first && id != s.triangle) {
            vec2 depths = texelFetch(intervalDepths, i).xy;
            float from = max(tickAt(s, times.x), wanted.x), to = min(tickAt(s, times.y), wanted.y);
            MapInterval caster = MapInterval(times.x, times.y, depths.x, depths.y, id);
            vec2 nearer = negativeSpan(from, to, depthAt(caster, timeOf(s, from)) - comparedAt(p, from),
                                       depthAt(caster, timeOf(s, to)) - comparedAt(p, to));
#ifdef CUTOUTS
            bool cut = id != NO_INTERVAL_ID && isCutOut(id);
            ONLY_IF(cut) dark = withCovered(dark, s, id, nearer);
            if (cut) nearer.y = nearer.x;
#endif
            dark = withInterval(dark, nearer.x, nearer.y);
            isSettled = dark.full != 0u || dark.covered >= wanted.y - wanted.x;
        }
    }
    return dark;
}
#endif

// When a part is in shadow, or does not face the light, between two ticks.
TimeUnion darkIn(ReceiverSegment s, ComparedPart p, ivec2 texel, vec2 wanted) {
    TimeUnion dark = emptyTimeUnion();
    ONLY_IF(s.untested.covered > 0.0) dark = withUnion(dark, s.untested, wanted.x, wanted.y);
#if defined(NEAR_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
    PieceTicks ticks = PieceTicks(p.begin, p.end, wanted.x, wanted.y);
    for (int i = 0; i < nearCount; ++i) {
        uint id = texelFetch(nearTriangles, i).x;
        if (id == s.triangle) continue;
        MotionPiece m = motionPiece(s, fetchMotion(trianglePositions, id, true), p.begin, p.end);
        float missed = 0.0;
        dark = withCaster(dark, id, m, ticks, missed);
    }
#endif
    ONLY_IF(insideMap(texel)) {
#ifdef STATIC_TRIANGLES
        float still = mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x);
        vec2 behind =
            negativeSpan(wanted.x, wanted.y, still - comparedAt(p, wanted.x), still - comparedAt(p, wanted.y));
        dark = withInterval(dark, behind.x, behind.y);
#endif
#if defined(DYNAMIC_TRIANGLES) && !defined(STATIC_CASTERS_ONLY)
        dark = withList(dark, s, p, texel, wanted);
#endif
    }
    return dark;
}

// Exposure and moments of the times at which a part is lit, in one texel. Where the union is full the part is halved:
// nothing is merged.
vec3 litInTexel(ReceiverSegment s, ComparedPart p, ivec2 texel) {
    vec3 lit = vec3(0.0);
    vec2 wanted = vec2(p.begin, p.end);
    while (wanted.x < p.end) {
        TimeUnion dark = darkIn(s, p, texel, wanted);
        if (dark.full != 0u) {
            wanted.y = wanted.x + floor(0.5 * (wanted.y - wanted.x));
            continue;
        }
        lit += momentsOf(s, wanted.x, wanted.y);
        ONLY_IF(dark.covered > 0.0) lit -= momentsOf(s, dark, wanted.x, wanted.y);
        wanted = vec2(wanted.y, p.end);
    }
    return lit;
}

// The mean weight of a tap over the times at which it is lit: a weight is quadratic while the receiver moves straight
// on the map.
float meanWeight(vec3 weights, vec3 lit, float begin, float end) {
    if (lit.x <= 0.0 || begin >= end) return weights.y;
    vec2 moments = lit.yz / lit.x * vec2(TICKS, TICKS * TICKS);  // of ticks
    float length = end - begin, first = (moments.x - begin) / length;
    float second = (moments.y - 2.0 * begin * moments.x + begin * begin) / (length * length);
    vec3 change = vec3(weights.x, 4.0 * weights.y - 3.0 * weights.x - weights.z,
                       2.0 * weights.x - 4.0 * weights.y + 2.0 * weights.z);
    return clamp(change.x + change.y * first + change.z * second, 0.0, 1.0);
}

// Of a part of the way that stays between the same texels.
vec3 litInCell(ReceiverSegment s, PathInView path, ivec2 cell, float begin, float end) {
    PlaneInView open = planeAt(s, path, begin), close = planeAt(s, path, end);
#ifdef BILINEAR
    PlaneInView middle = planeAt(s, path, 0.5 * (begin + end));
#endif
    vec3 lit = vec3(0.0);
    for (int i = 0; i < taps; ++i) {
        ivec2 texel = tapOf(cell, i);
        ComparedPart p = ComparedPart(begin, end, comparedDepth(texel, open), comparedDepth(texel, close));
        vec3 seen = litInTexel(s, p, texel);
#ifdef BILINEAR
        vec3 weights = vec3(weightOf(cell, open.position * lightView.size, i),
                            weightOf(cell, middle.position * lightView.size, i),
                            weightOf(cell, close.position * lightView.size, i));
        seen *= meanWeight(weights, seen, begin, end);
#endif
        lit += seen;
    }
    return lit;
}

#ifdef AS_PUBLISHED
// Between two ticks throughout which the receiver faces the light.
vec3 litFacing(ReceiverSegment s, PathInView path, float begin, float end) {
    vec2 first = planeAt(s, path, begin).position * lightView.size;
    vec2 last = planeAt(s, path, end).position * lightView.size;
    if (floor(first) == floor(last)) {
        reached = end;
        return litInCell(s, path, cellAt(0.5 * (first + last)), begin, end);
    }
    float points = min(max(ceil(setting.points_per_texel * distance(first, last)), setting.least_points), POINTS);
    vec3 lit = vec3(0.0);
    for (float i = 0.0; i < points; ++i) {
        float from = floor(mix(begin, end, i / points) + 0.5), to = floor(mix(begin, end, (i + 1.0) / points) + 0.5);
        float tick = 0.5 * (from + to), u = timeOf(s, tick);
        float value = litInMap(planeAt(s, path, tick), s.triangle, u);
#ifdef NEAR_TRIANGLES
        Receiver r;
        r.triangle = s.triangle;
        r.time = u;
        r.position = mix(s.open, s.close, tick / TICKS);
        r.clearance = s.clearance;
        if (shadowedByNearTriangles(r, nearCount)) value = 0.0;
#endif
        lit += value * momentsOf(s, from, to);
        reached = to;
    }
    return lit;
}

// When after `begin` the receiver faces the light, from when to when.
vec2 nextFacing(ReceiverSegment s, float begin) {
    vec2 next = vec2(begin, s.last);
    TimeUnion away = s.untested;
    for (int round = 0; round < 8; ++round)
        for (int i = 0; i < 8; ++i) {
            float from = i < 4 ? away.begin0[i & 3] : away.begin1[i & 3];
            float to = i < 4 ? away.end0[i & 3] : away.end1[i & 3];
            if (from <= next.x && to > next.x) next.x = to;
        }
    for (int i = 0; i < 4; ++i) {
        if (away.begin0[i] > next.x) next.y = min(next.y, away.begin0[i]);
        if (away.begin1[i] > next.x) next.y = min(next.y, away.begin1[i]);
    }
    return next;
}

vec3 litOnWay(ReceiverSegment s, PathInView path) {
    vec3 lit = vec3(0.0);
    for (float begin = s.first; begin < s.last;) {
        vec2 facing = nextFacing(s, begin);
        if (facing.x < facing.y) lit += litFacing(s, path, facing.x, facing.y);
        begin = max(facing.y, facing.x);
    }
    return lit;
}

// The ends alone are projected; between them it is straight.
float allowedOffWay(Receiver open, Receiver close) { return 1e30; }
#else
float depthAtTick(ReceiverSegment s, PathInView path, ivec2 texel, float tick) {
    return comparedDepth(texel, planeAt(s, path, tick));
}

// The end of a part that begins at `begin`, over which the depth that is compared is within `depth_error` of linear at
// three times.
float straightUntil(ReceiverSegment s, PathInView path, ivec2 texel, float begin, float end) {
    float first = depthAtTick(s, path, texel, begin);
    for (int i = 0; i < HALVINGS; ++i) {
        float last = depthAtTick(s, path, texel, end), most = 0.0;
        for (float share = 0.25; share < 1.0; share += 0.25) {
            float tick = floor(mix(begin, end, share));
            float is = mix(first, last, (tick - begin) / max(end - begin, 1.0));
            most = max(most, abs(depthAtTick(s, path, texel, tick) - is));
        }
        if (most <= setting.depth_error * texelWidth(first)) break;
        end = floor(0.5 * (begin + end));
    }
    return end;
}

vec3 litOnWay(ReceiverSegment s, PathInView path) {
    vec3 lit = vec3(0.0);
    float begin = s.first;
    ivec2 cell = cellAt(onMap(mapBlossom(s, begin, begin)) * lightView.size);
    int left = 64 + 4 * int(lightView.size.x + lightView.size.y);  // no way is longer, whatever is rounded
    while (begin < s.last && left > 0) {
        --left;
        CellPiece p = pieceIn(s, cell, (vec2(cell) + firstTap) / lightView.size,
                              (vec2(cell) + firstTap + 1.0) / lightView.size, begin, s.last);
        float end = straightUntil(s, path, cell, begin, p.end);
        if (end > begin) lit += litInCell(s, path, cell, begin, end);
        reached = begin = end;
        if (end >= p.end) cell += p.onwards;
    }
    return lit;
}

// 1/32 of a texel: surfaces that the light grazes would be lit too long with 1/8.
float allowedOffWay(Receiver open, Receiver close) {
    return 0.03125 * min(texelWidth(inLightView(open.position, open.time).z),
                       texelWidth(inLightView(close.position, close.time).z));
}
#endif

vec4 exposuresOver(ReceiverSegment s) {
    if (s.first >= s.last) return vec4(0.0);
    reached = s.first;
    vec3 lit = litOnWay(s, pathInView(fetchTriangle(s.triangle), vec3(1.0, 0.0, 0.0)));
    float tested = exposureUntil(s, reached) - exposureUntil(s, s.first) - exposureOf(s, s.untested, s.first, reached);
    return vec4(lit.x, tested, lit.yz) / TICKS;
}
