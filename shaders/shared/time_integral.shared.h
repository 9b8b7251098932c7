#ifdef __cplusplus
#pragma once
#endif
#include "shared/cubic.shared.h"
#include "shared/segment_triangle.shared.h"
#include "shared/time_union.shared.h"

// What moves, and with it the degrees in time of the polynomials that decide a shadow (docs/numerics.md, "Integrals
// over time").
#define MOTION_NONE 0u   // nothing: constants
#define MOTION_LIGHT 1u  // the light alone: edges linear, W constant
#define MOTION_SCENE 2u  // receiver and caster, under a direction of light that stays: edges quadratic, W cubic
#define MOTION_ALL 3u    // everything: cubics
// How much more than a wanted part of a piece is looked at, as a share of the piece.
#define PART_SLACK SHARED_FLOAT(1.5258789e-5)

SHARED_BEGIN

/// A piece of the motion of a receiver and a caster, as t runs from 0 to 1. All vectors begin at the receiver, world
/// units, and are linear in t.
struct MotionPiece {
    vec3 lightOpen, lightClose;   // to the light, or along a direction as far as the map is deep
    vec3 open0, open1, open2;     // to the caster's vertices at t = 0
    vec3 close0, close1, close2;  // at t = 1
    float clearance;              // receiverClearance, of the middle of the piece
};

/// Bernstein coefficients of a vector that is quadratic in t.
struct QuadraticVector {
    vec3 first, middle, last;
};

/// Without contraction, so that a x b is exactly -(b x a): triangles that share an edge change sides at one time.
SHARED_FUNCTION vec3 crossOf(vec3 a, vec3 b) {
    SHARED_PRECISE vec3 c = vec3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
    return c;
}

/// Of a(t) x b(t), both linear.
SHARED_FUNCTION QuadraticVector crossCoefficients(vec3 a0, vec3 a1, vec3 b0, vec3 b1) {
    SHARED_PRECISE vec3 middle = SHARED_FLOAT(0.5) * (crossOf(a0, b1) + crossOf(a1, b0));
    return QuadraticVector(crossOf(a0, b0), middle, crossOf(a1, b1));
}

SHARED_FUNCTION float dotOf(vec3 a, vec3 b) {
    SHARED_PRECISE float d = a.x * b.x + a.y * b.y + a.z * b.z;
    return d;
}

/// Bernstein coefficients of the cubic a(t) . n(t), a linear and n quadratic: the blossom.
SHARED_FUNCTION vec4 dotCoefficients(vec3 a0, vec3 a1, QuadraticVector n) {
    const float third = SHARED_FLOAT(0.33333334), twice = SHARED_FLOAT(2.0);
    SHARED_PRECISE vec4 c = vec4(dotOf(a0, n.first), (dotOf(a1, n.first) + twice * dotOf(a0, n.middle)) * third,
                                 (dotOf(a0, n.last) + twice * dotOf(a1, n.middle)) * third, dotOf(a1, n.last));
    return c;
}

/// Twice det[light, a, b] over the piece, as edgeSide has it. The coefficients of MOTION_LIGHT are those of a line in x
/// and w, those of MOTION_SCENE those of a quadratic in x, y and w; y and z repeat others, so that in every case the
/// polynomial lies between the least and the greatest. Swapping a and b flips all signs exactly.
SHARED_FUNCTION vec4 edgeCoefficients(MotionPiece p, vec3 a0, vec3 b0, vec3 a1, vec3 b1, uint motion) {
    SHARED_PRECISE vec3 sum0 = b0 + a0;
    SHARED_PRECISE vec3 difference0 = b0 - a0;
    if (motion <= MOTION_LIGHT) {
        vec3 n = crossOf(sum0, difference0);
        float first = dotOf(p.lightOpen, n), last = dotOf(p.lightClose, n);
        return vec4(first, first, last, last);
    }
    SHARED_PRECISE vec3 sum1 = b1 + a1;
    SHARED_PRECISE vec3 difference1 = b1 - a1;
    QuadraticVector n = crossCoefficients(sum0, sum1, difference0, difference1);
    if (motion == MOTION_SCENE) {
        float middle = dotOf(p.lightOpen, n.middle);
        return vec4(dotOf(p.lightOpen, n.first), middle, middle, dotOf(p.lightOpen, n.last));
    }
    return dotCoefficients(p.lightOpen, p.lightClose, n);
}

/// The polynomials whose signs decide whether a triangle shadows a receiver: the three edges as above, and where its
/// plane is crossed.
struct ShadowSigns {
    vec4 edge0, edge1, edge2;
    vec4 plane;   // W less the clearance: the receiver in the triangle's plane
    vec4 beyond;  // W - V: the light in the triangle's plane
};

SHARED_FUNCTION ShadowSigns shadowSigns(MotionPiece p, uint motion) {
    ShadowSigns s;
    s.edge0 = edgeCoefficients(p, p.open1, p.open2, p.close1, p.close2, motion);
    s.edge1 = edgeCoefficients(p, p.open2, p.open0, p.close2, p.close0, motion);
    s.edge2 = edgeCoefficients(p, p.open0, p.open1, p.close0, p.close1, motion);
    QuadraticVector n =
        crossCoefficients(p.open1 - p.open0, p.close1 - p.close0, p.open2 - p.open0, p.close2 - p.close0);
    vec4 through = dotCoefficients(p.lightOpen, p.lightClose, n);
    s.plane = dotCoefficients(p.open0, p.close0, n);
    s.beyond = s.plane - through;
    // The clearance counts on the side of the plane that the light is on; |n| hardly changes where it matters.
    vec3 normal = SHARED_FLOAT(0.25) * (n.first + SHARED_FLOAT(2.0) * n.middle + n.last);
    float middle = through.x + SHARED_FLOAT(3.0) * (through.y + through.z) + through.w;
    float shift = p.clearance * length(normal);
    s.plane -= vec4(middle < SHARED_FLOAT(0.0) ? -shift : shift);
    return s;
}

/// Is the triangle proven to shadow the receiver at no time of the piece? Some edge is negative throughout and another
/// positive, or receiver and light are on one side of its plane throughout.
SHARED_FUNCTION bool neverShadows(ShadowSigns s) {
    vec3 least = vec3(leastOf(s.edge0), leastOf(s.edge1), leastOf(s.edge2));
    vec3 most = vec3(mostOf(s.edge0), mostOf(s.edge1), mostOf(s.edge2));
    const float zero = SHARED_FLOAT(0.0);
    bool apart = min(min(most.x, most.y), most.z) < zero && max(max(least.x, least.y), least.z) > zero;
    bool oneSide =
        (leastOf(s.plane) > zero && leastOf(s.beyond) > zero) || (mostOf(s.plane) < zero && mostOf(s.beyond) < zero);
    return apart || oneSide;
}

/// Bernstein coefficients of the part from `low` to `high`, of a polynomial of degree 1, 2 or 3 that is kept as
/// edgeCoefficients does.
SHARED_FUNCTION vec4 partOf(vec4 b, float low, float high, uint degree) {
    if (degree <= 1u) {
        float first = mix(b.x, b.w, low), last = mix(b.x, b.w, high);
        return vec4(first, first, last, last);
    }
    if (degree == 2u) {
        vec2 atLow = mix(vec2(b.x, b.y), vec2(b.y, b.w), low), atHigh = mix(vec2(b.x, b.y), vec2(b.y, b.w), high);
        float middle = mix(atLow.x, atLow.y, high);
        return vec4(mix(atLow.x, atLow.y, low), middle, middle, mix(atHigh.x, atHigh.y, high));
    }
    vec3 p = vec3(b.x, b.y, b.z), q = vec3(b.y, b.z, b.w);
    vec3 atLow = mix(p, q, low), atHigh = mix(p, q, high);
    vec2 lowLow = mix(vec2(atLow.x, atLow.y), vec2(atLow.y, atLow.z), low);
    vec2 lowHigh = mix(vec2(atLow.x, atLow.y), vec2(atLow.y, atLow.z), high);
    vec2 highHigh = mix(vec2(atHigh.x, atHigh.y), vec2(atHigh.y, atHigh.z), high);
    return vec4(mix(lowLow.x, lowLow.y, low), mix(lowLow.x, lowLow.y, high), mix(lowHigh.x, lowHigh.y, high),
                mix(highHigh.x, highHigh.y, high));
}

/// Nearer to 0, by `doubt`: what is of one sign then is so whatever is rounded.
SHARED_FUNCTION vec4 doubted(vec4 b, float doubt) {
    return sign(b) * max(abs(b) - vec4(doubt), vec4(SHARED_FLOAT(0.0)));
}

SHARED_FUNCTION ShadowSigns doubted(ShadowSigns s, float ofEdges, float ofPlanes) {
    return ShadowSigns(doubted(s.edge0, ofEdges), doubted(s.edge1, ofEdges), doubted(s.edge2, ofEdges),
                       doubted(s.plane, ofPlanes), doubted(s.beyond, ofPlanes));
}

/// The signs in a part of the piece, for neverShadows alone.
SHARED_FUNCTION ShadowSigns partOf(ShadowSigns s, float low, float high, uint motion) {
    uint ofPlane = motion <= MOTION_LIGHT ? 1u : 3u;
    return ShadowSigns(partOf(s.edge0, low, high, motion), partOf(s.edge1, low, high, motion),
                       partOf(s.edge2, low, high, motion), partOf(s.plane, low, high, ofPlane),
                       partOf(s.beyond, low, high, ofPlane));
}

/// How far the polynomials of edges (x) and planes (y) may be off: 2^-18 of the sizes of their terms.
SHARED_FUNCTION vec2 doubtsOf(MotionPiece p) {
    float far = max(length(p.lightOpen), length(p.lightClose));
    float across = max(max(max(length(p.open0), length(p.open1)), max(length(p.open2), length(p.close0))),
                       max(length(p.close1), length(p.close2)));
    float edge = max(max(length(p.open1 - p.open0), length(p.open2 - p.open0)),
                     max(length(p.close1 - p.close0), length(p.close2 - p.close0)));
    const float share = SHARED_FLOAT(3.8146973e-6);
    return vec2(share * SHARED_FLOAT(4.0) * far * across * edge, share * (far + across) * edge * edge);
}

/// Where one of them changes its sign in (0, 1); 2 for those that there are not. `degree`: 1, 2 or 3.
SHARED_FUNCTION vec3 changeTimes(vec4 b, uint degree) {
    const float none = SHARED_FLOAT(2.0);
    if (degree == 3u) {
        CubicSignChanges c = signChangesOfCubic(b);
        return vec3(c.count > 0u ? c.at.x : none, c.count > 1u ? c.at.y : none, c.count > 2u ? c.at.z : none);
    }
    if (degree == 2u) {
        SignChanges c = signChangesOfQuadratic(b.x, b.y, b.w);
        return vec3(c.count > 0u ? c.first : none, c.count > 1u ? c.second : none, none);
    }
    bool changes = (b.x < SHARED_FLOAT(0.0)) != (b.w < SHARED_FLOAT(0.0));
    return vec3(changes ? b.x / (b.x - b.w) : none, none, none);
}

/// All of them.
struct ChangeTimes {
    vec3 edge0, edge1, edge2, plane, beyond;
};

/// One solver for the five, which is inlined once.
SHARED_FUNCTION ChangeTimes changeTimesOf(ShadowSigns s, uint motion) {
    const vec3 none = vec3(SHARED_FLOAT(2.0));
    ChangeTimes at = ChangeTimes(none, none, none, none, none);
    if (motion == MOTION_NONE) return at;
    if (motion == MOTION_SCENE || motion == MOTION_LIGHT) {
        at.edge0 = changeTimes(s.edge0, motion);
        at.edge1 = changeTimes(s.edge1, motion);
        at.edge2 = changeTimes(s.edge2, motion);
    }
    if (motion == MOTION_LIGHT) {
        at.beyond = changeTimes(s.beyond, 1u);
        return at;
    }
    for (uint k = motion == MOTION_SCENE ? 3u : 0u; k < 5u; ++k) {
        vec4 b = k == 0u ? s.edge0 : (k == 1u ? s.edge1 : (k == 2u ? s.edge2 : (k == 3u ? s.plane : s.beyond)));
        vec3 found = none;
        // Most do not change: software renderers skip a loop that no lane enters.
        bool changes = leastOf(b) < SHARED_FLOAT(0.0) && mostOf(b) > SHARED_FLOAT(0.0);
        for (int rounds = changes ? 1 : 0; rounds > 0; --rounds) found = changeTimes(b, 3u);
        if (k == 0u) at.edge0 = found;
        if (k == 1u) at.edge1 = found;
        if (k == 2u) at.edge2 = found;
        if (k == 3u) at.plane = found;
        if (k == 4u) at.beyond = found;
    }
    return at;
}

/// The next change after t; 1 where there is none.
SHARED_FUNCTION float nextChange(ChangeTimes at, float t) {
    const vec3 end = vec3(SHARED_FLOAT(1.0));
    vec3 next =
        min(min(mix(end, at.edge0, greaterThan(at.edge0, vec3(t))), mix(end, at.edge1, greaterThan(at.edge1, vec3(t)))),
            min(mix(end, at.edge2, greaterThan(at.edge2, vec3(t))),
                min(mix(end, at.plane, greaterThan(at.plane, vec3(t))),
                    mix(end, at.beyond, greaterThan(at.beyond, vec3(t))))));
    return min(SHARED_FLOAT(1.0), min(min(next.x, next.y), next.z));
}

/// The definition of shadow, at t.
SHARED_FUNCTION bool shadowsAt(MotionPiece p, float t) {
    return segmentMeetsTriangle(mix(p.lightOpen, p.lightClose, t), mix(p.open0, p.close0, t), mix(p.open1, p.close1, t),
                                mix(p.open2, p.close2, t), p.clearance);
}

/// Where a piece lies in the interval of the mean, and what of that is wanted; ticks, whole.
struct PieceTicks {
    float begin, end;  // of the piece
    float from, to;    // only what lies between these is added to the union
};

SHARED_FUNCTION float tickOf(PieceTicks ticks, float t) {
    return floor(ticks.begin + t * (ticks.end - ticks.begin) + SHARED_FLOAT(0.5));
}

/// The union with the times at which the triangle shadows the receiver. The changes of sign cut the piece into gaps,
/// and each gap is decided by the definition at its middle, never by counting changes: one that is missed, or that is
/// off, costs its own gap. What is added depends on the piece alone, so that parts of it, from..to, are exactly parts
/// of it. Each end is off by at most half a tick and the error of a change (cubic.shared.h), 2^-18 max |b| over the
/// slope there.
SHARED_FUNCTION TimeUnion withShadow(TimeUnion u, MotionPiece p, PieceTicks ticks, uint motion) {
    ShadowSigns signs = shadowSigns(p, motion);
    bool never = neverShadows(signs);
    if (ticks.from > ticks.begin || ticks.to < ticks.end) {
        // A little more than what is wanted, for what is rounded; the same would be found without this.
        float span = ticks.end - ticks.begin;
        float low = clamp((ticks.from - ticks.begin) / span - PART_SLACK, SHARED_FLOAT(0.0), SHARED_FLOAT(1.0));
        float high = clamp((ticks.to - ticks.begin) / span + PART_SLACK, SHARED_FLOAT(0.0), SHARED_FLOAT(1.0));
        vec2 doubts = doubtsOf(p);
        never = never || neverShadows(doubted(partOf(signs, low, high, motion), doubts.x, doubts.y));
    }
    // A loop of one round: software renderers skip what no lane enters.
    for (int rounds = never ? 0 : 1; rounds > 0; --rounds) {
        ChangeTimes at = changeTimesOf(signs, motion);
        for (float t = SHARED_FLOAT(0.0); t < SHARED_FLOAT(1.0);) {
            float next = nextChange(at, t);
            float begin = max(tickOf(ticks, t), ticks.from), end = min(tickOf(ticks, next), ticks.to);
            bool adds = begin < end && shadowsAt(p, SHARED_FLOAT(0.5) * (t + next));
            for (int add = adds ? 1 : 0; add > 0; --add) u = withInterval(u, begin, end);
            t = next;
        }
    }
    return u;
}

/// The cubic that a polynomial kept as edgeCoefficients does is.
SHARED_FUNCTION vec4 asCubic(vec4 b, uint degree) {
    const float third = SHARED_FLOAT(0.33333334), twice = SHARED_FLOAT(2.0);
    if (degree <= 1u) return vec4(b.x, (twice * b.x + b.w) * third, (b.x + twice * b.w) * third, b.w);
    if (degree == 2u) return vec4(b.x, (b.x + twice * b.y) * third, (twice * b.y + b.w) * third, b.w);
    return b;
}

/// How far around t a cubic is within `doubt` of 0: to a power of two, at most 1.
SHARED_FUNCTION float doubtAround(vec4 b, float t, float doubt) {
    float reach = SHARED_FLOAT(1.1920929e-7);
    while (reach < SHARED_FLOAT(1.0) && min(abs(cubicAt(b, t - reach)), abs(cubicAt(b, t + reach))) <= doubt)
        reach *= SHARED_FLOAT(2.0);
    return SHARED_FLOAT(2.0) * reach;
}

/// During how much of [0, 1] at most the sign of a cubic is in doubt: around its changes, its turns and the ends.
SHARED_FUNCTION float changeDoubt(vec4 b, float doubt) {
    if (leastOf(b) > doubt || mostOf(b) < -doubt) return SHARED_FLOAT(0.0);
    CubicSignChanges c = signChangesOfCubic(b);
    SignChanges turns = signChangesOfQuadratic(b.y - b.x, b.z - b.y, b.w - b.z);
    float sum = SHARED_FLOAT(0.0);
    for (uint i = 0u; i < 7u; ++i) {
        float t = i == 0u ? c.at.x : (i == 1u ? c.at.y : c.at.z);
        if (i == 3u) t = turns.first;
        if (i == 4u) t = turns.second;
        if (i >= 5u) t = i == 5u ? SHARED_FLOAT(0.0) : SHARED_FLOAT(1.0);
        bool counts = i < 3u ? i < c.count : (i >= 5u || i - 3u < turns.count);
        if (counts && abs(cubicAt(b, t)) <= doubt) sum += doubtAround(b, t, doubt);
    }
    return sum;
}

/// A bound on the error, as a share of the piece, of what withShadow adds: half a tick at each of two ends, and the
/// times at which a polynomial is as near to 0 as it may be off. At most 1.
SHARED_FUNCTION float shadowDoubt(MotionPiece p, uint motion) {
    ShadowSigns s = shadowSigns(p, motion);
    vec2 doubts = doubtsOf(p);
    if (neverShadows(doubted(s, doubts.x, doubts.y))) return SHARED_FLOAT(0.0);
    float doubt = changeDoubt(asCubic(s.edge0, motion), doubts.x) + changeDoubt(asCubic(s.edge1, motion), doubts.x) +
                  changeDoubt(asCubic(s.edge2, motion), doubts.x) + changeDoubt(s.plane, doubts.y) +
                  changeDoubt(s.beyond, doubts.y) + SHARED_FLOAT(1.0) / TICKS;
    return min(doubt, SHARED_FLOAT(1.0));
}

SHARED_END
