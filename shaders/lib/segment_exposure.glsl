// How much a camera receives while a segment of a receiver is lit: exposures and moments over unions of times.
//
// SOLVES_INTERVALS: defines litAlong by exposuresOver and allowedOffWay, which the technique defines.
#include "lib/receiver_segment.glsl"
#include "shared/shutter_response.shared.h"

MotionPiece motionPiece(ReceiverSegment s, VertexMotion v, float begin, float end) {
    float u0 = timeOf(s, begin), u1 = timeOf(s, end);
    vec3 from = mix(s.open, s.close, begin / TICKS), to = mix(s.open, s.close, end / TICKS);
    SeenVertices open = seenVertices(v, from, u0), close = seenVertices(v, to, u1);
    return MotionPiece(mix(s.toOpen, s.toClose, begin / TICKS), mix(s.toOpen, s.toClose, end / TICKS), open.v0, open.v1,
                       open.v2, close.v0, close.v1, close.v2, s.clearance);
}

// The union with the part of another between two ticks.
TimeUnion withUnion(TimeUnion u, TimeUnion other, float from, float to) {
    for (int i = 0; i < 4; ++i) {
        u = withInterval(u, max(other.begin0[i], from), min(other.end0[i], to));
        u = withInterval(u, max(other.begin1[i], from), min(other.end1[i], to));
    }
    return u;
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

#ifdef SOLVES_INTERVALS
float exposureUntil(float u) { return shutterExposure(frame.response, frame.responseWidth, u); }

// Of a segment that is a part of another, from `begin` to `end` of it: moments as of the other.
vec4 asPart(vec4 e, float begin, float end) {
    float length = end - begin;
    e.w = begin * begin * e.x + 2.0 * begin * length * e.z + length * length * e.w;
    e.z = begin * e.x + length * e.z;
    return e;
}

// Of the segment: the exposure during which the receiver sees the light (x), that during which it is tested (y), as
// shares of the segment's, and the integrals over the former of the time and of its square (z, w).
vec4 exposuresOver(ReceiverSegment s);
// How far a chord may leave the receiver's way, in world units.
float allowedOffWay(Receiver open, Receiver close);

vec4 litAlong(MovingTriangle t, uint id, vec2 position, float u0, float u1) {
    Receiver open = receiverOnRay(t, id, position, u0), last = receiverOnRay(t, id, position, u1);
    int chords = chordsOf(t, open, last, position, allowedOffWay(open, last));
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
