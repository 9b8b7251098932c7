// The tuples (begin, end, distance at begin, distance at end, triangle) of one moving triangle at one texel: one for
// each coverage interval of the texel's centre, at its exact times. Drawn twice by the same program: first to count,
// then (filling) to write.
//
// COVERAGE_MAP: tuples wholly behind a triangle that covers the texel all through the shutter are left out.
#include "lib/cell_lists.glsl"
#include "lib/only_if.glsl"
#include "techniques/temporal/bindings.shared.h"
#include "lib/covering_triangle.glsl"

#ifdef COVERAGE_MAP
#include "techniques/temporal/coverage.glsl"
layout(std430, binding = TUPLE_COUNTS_BINDING) buffer TupleCounts { uint skippedTuples; };
#endif

layout(std430, binding = TUPLE_TIMES_BINDING) writeonly buffer TupleTimes { vec2 tupleTimes[]; };
layout(std430, binding = TUPLE_DEPTHS_BINDING) writeonly buffer TupleDepths { vec2 tupleDepths[]; };
layout(std430, binding = TUPLE_IDS_BINDING) writeonly buffer TupleIds { uint tupleIds[]; };
uniform uint filling;

#ifdef COVERAGE_MAP
#define NEEDS_DEPTHS true
#else
// While counting, only the number of pieces depends on them.
#define NEEDS_DEPTHS (filling != 0u || nonTranslating != 0u)
#endif

// Distance is linear in u while a triangle only translates. Else an interval is cut into pieces until the chord is this
// near, in texels.
const float MAX_BEND = 0.25;
const float MAX_PIECES = 8.0;

float pieces(float begin, float middle, float end) {
    float bend = abs(middle - 0.5 * (begin + end));
    return clamp(ceil(sqrt(bend / (MAX_BEND * texelWidth(middle)))), 1.0, MAX_PIECES);
}

void main() {
    SeenTriangle t = seenTriangle(texelCentre());
    precise EdgeQuadratics e = quadraticsOf(t);
    CoverageIntervals intervals = intervalsOfTranslation(e);
    ONLY_IF(nonTranslating != 0u) intervals = intervalsOf(e);
    uint cell = uint(gl_FragCoord.y) * frame.mapWidth + uint(gl_FragCoord.x);
#ifdef COVERAGE_MAP
    float covered = 0.0;
    ONLY_IF(intervals.count > 0) covered = coverageDistance(ivec2(gl_FragCoord.xy));
#endif
    for (int i = 0; i < intervals.count; ++i) {
        float begin = intervals.begins[i], end = intervals.ends[i];
        float count = 1.0, depth = 0.0, last = 0.0;
        ONLY_IF(NEEDS_DEPTHS) {
            depth = casterDistance(t, begin);
            last = casterDistance(t, end);
        }
        ONLY_IF(nonTranslating != 0u) count = pieces(depth, casterDistance(t, 0.5 * (begin + end)), last);
        for (float piece = 1.0; piece <= count; piece += 1.0) {
            float pieceEnd = end, pieceDepth = last;
            ONLY_IF(piece < count) {
                pieceEnd = mix(intervals.begins[i], end, piece / count);
                pieceDepth = casterDistance(t, pieceEnd);
            }
            bool kept = true;
#ifdef COVERAGE_MAP
            kept = min(depth, pieceDepth) <= covered;
            ONLY_IF(!kept && filling == 0u) atomicAdd(skippedTuples, 1u);
#endif
            ONLY_IF(kept) {
                uint slot = listSlot(cell);
                ONLY_IF(filling != 0u && slot < uint(tupleTimes.length())) {
                    tupleTimes[slot] = vec2(begin, pieceEnd);
                    tupleDepths[slot] = vec2(depth, pieceDepth);
                    tupleIds[slot] = triangleId;
                }
            }
            begin = pieceEnd;
            depth = pieceDepth;
        }
    }
}
