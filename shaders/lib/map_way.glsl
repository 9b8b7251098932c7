// The way of a receiver through the cells of the light's map.
#include "lib/receiver_segment.glsl"

// A part of the way that stays in one cell.
struct CellPiece {
    ivec2 cell;
    float begin, end;  // ticks
    vec3 open, close;  // in the light's view
    vec3 middle;       // Bernstein coefficient
    ivec2 onwards;     // to the cell after it
};

// The way from tick `a` to tick `b`: its blossom.
vec3 mapBlossom(ReceiverSegment s, float a, float b) {
    float ta = a / TICKS, tb = b / TICKS;
    return mix(mix(s.mapOpen, s.mapMiddle, ta), mix(s.mapMiddle, s.mapClose, ta), tb);
}

// When, as a share of the piece, a border is passed: f <= 0 on this side of it, at the begin, by the coefficient
// between, at the end. More than 1: it is not passed.
float exitAt(float begin, float middle, float end) {
    if (begin > 0.0 || (begin == 0.0 && middle > 0.0)) return 0.0;
#ifdef LIGHT_ORTHOGRAPHIC
    SignChanges c = signChangesOfQuadratic(begin, middle, end);
    return c.count > 0u ? c.first : 2.0;
#else
    return end > 0.0 ? begin / (begin - end) : 2.0;
#endif
}

vec2 onMap(vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return v.xy;
#else
    return v.xy / v.z;
#endif
}

float scaleOf(vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return 1.0;
#else
    return v.z;
#endif
}

// The piece that begins at `begin` in `cell` and ends at `end`, or before, where the way leaves the cell, which reaches
// from `lowest` to `highest` in the map.
CellPiece pieceIn(ReceiverSegment s, ivec2 cell, vec2 lowest, vec2 highest, float begin, float end) {
    CellPiece p;
    p.cell = cell;
    p.begin = begin;
    p.onwards = ivec2(0);
    vec3 a = mapBlossom(s, begin, begin), m = mapBlossom(s, begin, end), b = mapBlossom(s, end, end);
    float exit = 1.0;
    for (int axis = 0; axis < 2; ++axis) {
        float low = lowest[axis], high = highest[axis];
        float beyond = exitAt(a[axis] - high * scaleOf(a), m[axis] - high * scaleOf(m), b[axis] - high * scaleOf(b));
        float before = exitAt(low * scaleOf(a) - a[axis], low * scaleOf(m) - m[axis], low * scaleOf(b) - b[axis]);
        if (min(beyond, before) < exit) {
            exit = min(beyond, before);
            p.onwards = ivec2(0);
            p.onwards[axis] = beyond < before ? 1 : -1;
        }
    }
    p.end = floor(mix(begin, end, exit) + 0.5);
    p.open = a;
    p.middle = mapBlossom(s, begin, p.end);
    p.close = mapBlossom(s, p.end, p.end);
    return p;
}
