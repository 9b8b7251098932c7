// What a mean over time is taken of: a receiver that moves straight and evenly, and of its interval the times at which
// it faces the light inside its cone. Where it comes from (a point of a triangle, or a chord of a ray's way over one)
// makes no difference to the union of the times at which it is shadowed.
#include "lib/light_map.glsl"
#include "lib/only_if.glsl"
#include "lib/segment_test.glsl"
#include "shared/time_integral.shared.h"

struct ReceiverSegment {
    uint triangle;           // which casts no shadow on it
    float u0, u1;            // its interval of the shutter
    vec3 open, close;        // where it is at u0 and at u1
    vec3 toOpen, toClose;    // to the light, as segmentToLight has it
    float clearance;         // receiverClearance at the middle
    vec3 mapOpen, mapClose;  // in the light's view (ViewBlock) at u0 and at u1
    vec3 mapMiddle;          // and the Bernstein coefficient between: a sun that turns bends the way
    float first, last;       // ticks: outside of these it is outside the light's cone
    TimeUnion untested;      // between them, it does not face the light
};

float timeOf(ReceiverSegment s, float tick) { return s.u0 + (s.u1 - s.u0) * (tick / TICKS); }

vec3 inLightView(vec3 p, float u) {
    return mix(transformed(lightView.viewFromWorldOpen, p), transformed(lightView.viewFromWorldClose, p), u);
}

// A point of a triangle between two of its times.
struct PointOnTriangle {
    MovingTriangle triangle;
    Receiver open, close;  // at both ends
    vec3 eyeOpen, eyeClose;
};

bool facesAt(PointOnTriangle p, vec4 facing, vec4 towardsEye, float t) {
    float side = p.triangle.doubleSided && cubicAt(towardsEye, t) < 0.0 ? -1.0 : 1.0;
    return side * cubicAt(facing, t) > 0.0;
}

// Where the triangle does not face the light: of a two-sided one, the side that the camera is on.
TimeUnion facingAway(PointOnTriangle p) {
    TimeUnion away = emptyTimeUnion();
    QuadraticVector normal = crossCoefficients(p.open.edge1, p.close.edge1, p.open.edge2, p.close.edge2);
#ifdef SOLVES_INTERVALS
    // From a vertex: a chord leaves the triangle's plane.
    vec3 open = mix(p.triangle.open0, p.triangle.close0, p.open.time),
         close = mix(p.triangle.open0, p.triangle.close0, p.close.time);
#else
    vec3 open = p.open.position, close = p.close.position;
#endif
    vec4 facing =
        dotCoefficients(towardsLight(open, p.open.time), towardsLight(close, p.close.time), normal);
    vec4 towardsEye = dotCoefficients(p.eyeOpen - p.open.position, p.eyeClose - p.close.position, normal);
    bool always = leastOf(facing) > 0.0 && (!p.triangle.doubleSided || leastOf(towardsEye) > 0.0);
    PieceTicks all = PieceTicks(0.0, TICKS, 0.0, TICKS);
    ONLY_IF(!always) {
        ChangeTimes at;
        at.edge0 = changeTimes(facing, 3u);
        at.edge1 = p.triangle.doubleSided ? changeTimes(towardsEye, 3u) : vec3(2.0);
        at.edge2 = at.plane = at.beyond = vec3(2.0);
        for (float t = 0.0; t < 1.0;) {
            float next = nextChange(at, t);
            if (!facesAt(p, facing, towardsEye, 0.5 * (t + next)))
                away = withInterval(away, tickOf(all, t), tickOf(all, next));
            t = next;
        }
    }
    return away;
}

bool isInCone(ReceiverSegment s, float tick) {
    float u = timeOf(s, tick);
    vec3 l = mix(s.toOpen, s.toClose, tick / TICKS);
    return dot(-l, lightDirectionAt(u)) >= frame.lightCone.x * length(l);
}

// The border of the cone between a time outside and one inside.
float borderOfCone(ReceiverSegment s, float outside, float inside) {
    ONLY_IF(!isInCone(s, outside)) {
        while (abs(inside - outside) > 1.0) {
            float middle = floor(0.5 * (outside + inside));
            if (isInCone(s, middle))
                inside = middle;
            else
                outside = middle;
        }
        outside = inside;
    }
    return outside;
}

// A time at which the receiver may be inside the cone though it is outside at both ends: where (axis . l)^2 - cos^2 l^2
// is greatest, for the axis in the middle.
float deepestInCone(ReceiverSegment s) {
    vec3 axis = lightDirectionAt(0.5 * (s.u0 + s.u1)), step = s.toClose - s.toOpen;
    float cosine2 = frame.lightCone.x * frame.lightCone.x;
    float a = dot(axis, step) * dot(axis, step) - cosine2 * dot(step, step);
    float b = dot(axis, s.toOpen) * dot(axis, step) - cosine2 * dot(s.toOpen, step);
    return a < 0.0 ? clamp(floor(-b / a * TICKS), 0.0, TICKS) : floor(0.5 * TICKS);
}

// The segment between two places of a receiver, straight and even; when it is inside the cone is found from `seen`, a
// tick at which it may be.
ReceiverSegment segmentBetween(PointOnTriangle p, float u0, float u1) {
    ReceiverSegment s;
    p.eyeOpen = mix(frame.cameraPositionOpen.xyz, frame.cameraPositionClose.xyz, u0);
    p.eyeClose = mix(frame.cameraPositionOpen.xyz, frame.cameraPositionClose.xyz, u1);
    s.triangle = p.open.triangle;
    s.u0 = u0;
    s.u1 = u1;
    s.open = p.open.position;
    s.close = p.close.position;
    s.toOpen = segmentToLight(s.open, u0);
    s.toClose = segmentToLight(s.close, u1);
    s.clearance = 0.5 * (p.open.clearance + p.close.clearance);
    s.mapOpen = inLightView(s.open, u0);
    s.mapClose = inLightView(s.close, u1);
#ifdef LIGHT_ORTHOGRAPHIC
    vec3 middle = inLightView(0.5 * (s.open + s.close), 0.5 * (u0 + u1));
    s.mapMiddle = 2.0 * middle - 0.5 * (s.mapOpen + s.mapClose);
#else
    s.mapMiddle = 0.5 * (s.mapOpen + s.mapClose);
#endif
    s.first = 0.0;
    s.last = TICKS;
    s.untested = facingAway(p);
    return s;
}

// Leaves of the segment what is inside the cone; `seen` is a tick at which it is.
ReceiverSegment insideCone(ReceiverSegment s, float seen) {
    s.first = borderOfCone(s, 0.0, seen);
    s.last = borderOfCone(s, TICKS, seen);
    return s;
}

// The receiver of a camera sample, which is inside the cone and faces the light, followed on its triangle.
ReceiverSegment segmentOn(MovingTriangle t, Receiver r, float u0, float u1) {
    PointOnTriangle p;
    p.triangle = t;
    p.open = pointAt(t, r.triangle, r.barycentrics, u0);
    p.close = pointAt(t, r.triangle, r.barycentrics, u1);
    ReceiverSegment s = segmentBetween(p, u0, u1);
#ifndef LIGHT_ORTHOGRAPHIC
    float seen = u1 > u0 ? clamp(floor((r.time - u0) / (u1 - u0) * TICKS), 0.0, TICKS) : 0.0;
    s = insideCone(s, seen);
#endif
    return s;
}

#ifdef SOLVES_INTERVALS
const int mostChords = 64;

// What the ray of an image position sees of a triangle: the chord between two times.
ReceiverSegment segmentAlong(MovingTriangle t, Receiver open, Receiver close) {
    PointOnTriangle p;
    p.triangle = t;
    p.open = open;
    p.close = close;
    ReceiverSegment s = segmentBetween(p, open.time, close.time);
#ifndef LIGHT_ORTHOGRAPHIC
    float seen = isInCone(s, 0.0) ? 0.0 : isInCone(s, TICKS) ? TICKS : deepestInCone(s);
    if (isInCone(s, seen))
        s = insideCone(s, seen);
    else
        s.last = s.first;
#endif
    return s;
}

float leavesChord(MovingTriangle t, Receiver open, Receiver close, vec2 position, float share) {
    Receiver r = receiverOnRay(t, open.triangle, position, mix(open.time, close.time, share));
    return length(r.position - mix(open.position, close.position, share));
}

// Into how many chords the way is cut, none of which leaves the path by more than `allowed`, nor is held to less than
// rounding: what a chord leaves the path by falls with the square of their number.
int chordsOf(MovingTriangle t, Receiver open, Receiver close, vec2 position, float allowed) {
    float away = 0.0;
    ONLY_IF(open.position != close.position) {
        away = max(max(leavesChord(t, open, close, position, 0.25), leavesChord(t, open, close, position, 0.5)),
                   leavesChord(t, open, close, position, 0.75));
    }
    allowed = max(allowed, 2.0 * (open.clearance + close.clearance));
    return clamp(int(ceil(sqrt(away / allowed))), 1, mostChords);
}
#endif
