// One texel of a prism's surface: when the triangle begins or ceases to cover its centre, at which distance, and how
// both change from there to the rest of the texel. Drawn twice, without and with FILL: to count the fragments of each
// texel, and to put them into its list.
#include "lib/blocks.glsl"
#include "lib/cell_lists.glsl"
#include "techniques/ranges/prism_parts.glsl"

#ifdef FILL
in float prismTime;
in vec3 prismCorners;
#ifdef LIGHT_ORTHOGRAPHIC
in float prismDistance;
#endif
flat in uint prismId;
flat in uint prismPart;
flat in uint prismMoves;
flat in vec3 prismTwist;

#include "lib/light_projection.glsl"
#include "shared/prism_side.shared.h"
#include "techniques/ranges/fragment_lists.glsl"

struct SurfacePoint {
    float time;
    float distance;
    vec2 timeSlope;  // change per texel
    vec2 rise;       // of the distance, per texel
};

SurfacePoint interpolatedPoint() {
    SurfacePoint p;
    p.time = prismTime;
#ifdef LIGHT_ORTHOGRAPHIC
    p.distance = prismDistance;
#else
    p.distance = 1.0 / gl_FragCoord.w;
#endif
    p.timeSlope = vec2(dFdx(p.time), dFdy(p.time));
    p.rise = vec2(dFdx(p.distance), dFdy(p.distance));
    return p;
}

// A side is bilinear, and what is drawn are four flat triangles. The point of the side with this point's place and time
// is seen by another texel; from there the slopes lead back to this texel's centre. Where that would change the time by
// more than the fan is ever off for an edge that moves more than it turns, slopes are no guide so far away, and the
// change is limited.
void moveToSide(inout SurfacePoint p, float place) {
    const float longest = 1.0 / 16.0;
    vec3 beyond = beyondFan(place, p.time) * prismTwist;
#ifdef LIGHT_ORTHOGRAPHIC
    vec2 away = beyond.xy * lightView.size;
#else
    vec2 away = (beyond.xy * lightView.size - gl_FragCoord.xy * beyond.z) / (p.distance + beyond.z);
#endif
    float later = -dot(p.timeSlope, away);
    float share = min(1.0, longest / max(abs(later), 1e-20));
    p.time = clamp(p.time + share * later, 0.0, 1.0);
    p.distance += share * (beyond.z - dot(p.rise, away));
}

// Slopes are followed to the rest of the texel as far as the triangle's edge is long: an edge that slides along itself
// would else cover the texel for as long as the line through it does, with the plane of a triangle that has passed long
// before.
void holdToEdge(inout SurfacePoint p, float place, vec2 placeSlope) {
    float share = stepWithinEdge(p.timeSlope, placeSlope, place);
    p.timeSlope *= share;
    p.rise *= share;
}

// Two halves each; distances in texels, so that the size of the world does not matter.
uvec2 packedSlopes(SurfacePoint p) {
    const float MAX_HALF = 65504.0;
    vec2 rise = clamp(p.rise / texelWidth(p.distance), -MAX_HALF, MAX_HALF);
    return uvec2(packHalf2x16(p.timeSlope), packHalf2x16(rise));
}
#endif

void main() {
    uint slot = listSlot(uint(gl_FragCoord.y) * frame.mapWidth + uint(gl_FragCoord.x));
#ifdef FILL
    SurfacePoint p = interpolatedPoint();
    float place = 1.0 - prismCorners[max(prismPart, PART_SIDE) - PART_SIDE];
    vec2 placeSlope = vec2(dFdx(place), dFdy(place));
    // False for NaN, too.
    bool seenFlat = all(lessThan(abs(p.timeSlope), vec2(1e4))) && all(lessThan(abs(p.rise), vec2(1e15)));
    if (prismPart < PART_SIDE) {
        p.time = float(prismPart - PART_OPEN);  // interpolation would round it
        p.timeSlope = vec2(0.0);
    } else if (seenFlat) {
        moveToSide(p, place);
        holdToEdge(p, place, placeSlope);
    }
    if (!seenFlat) p.timeSlope = p.rise = vec2(0.0);  // seen edge-on: slopes are not defined
    if (prismMoves == 0u) p.rise = vec2(0.0);         // as in an ordinary map: lit values must not depend on the plan
    if (slot >= uint(fragmentTimes.length())) return;
    fragmentTimes[slot] = clamp(p.time, 0.0, 1.0);
    fragmentDistances[slot] = p.distance;
    fragmentSlopes[slot] = packedSlopes(p);
    fragmentIds[slot] = prismId;
#endif
}
