// All camera samples of a pixel against this frame's map; their mean lit value is merged with the history of the
// surface, and written back to the samples so that the pixel's mean is the merged one.
//
// MOVED: the camera or something in the scene has moved since the frame before, so that the history is reprojected.
// TRIES_TRIANGLES: as in map_test.glsl; then the pixel's re-test period is written as well.
#include "shared/shutter_response.shared.h"
#include "techniques/history/cameras.glsl"
#include "techniques/history/map_test.glsl"
#include "techniques/history/texel.glsl"

layout(early_fragment_tests) in;  // or converged pixels would be drawn

uniform sampler2D past;
#ifdef MOVED
uniform samplerBuffer previousPositions;
uniform sampler2DArray dynamicMask;
uniform usamplerBuffer dynamicFlags;
#endif
layout(r32f) uniform image2DArray visibility;

layout(location = 0) out vec4 outputHistory;
#ifdef TRIES_TRIANGLES
layout(location = 1) out uint outputPeriod;
#endif

// The sample that the pixel's history is about.
struct Seen {
    bool any;
    uint id;
    uint stratum;
    Receiver receiver;
};

// This frame's tests of a pixel's samples, summed up.
struct PixelTests {
    Seen seen;
    uint testedStrata;  // one bit each
    float count;        // of tested samples, each by its weight in the picture
    float litSum, weightSum, weightedLit;
    vec2 low, high;      // of their positions in the light's image plane
    bool sure, proven;   // every sample
    bool receiverMoves;  // in any sample
    bool overlapped;     // by a dynamic caster, in any sample
};

PixelTests noTests() {
    PixelTests tests;
    tests.seen.any = false;
    tests.testedStrata = 0u;
    tests.count = tests.litSum = tests.weightSum = tests.weightedLit = 0.0;
    tests.low = vec2(1.0);  // nowhere: the last cell before the first
    tests.high = vec2(0.0);
    tests.sure = true;
    tests.proven = history.keepsProof != 0u;
    tests.receiverMoves = tests.overlapped = false;
    return tests;
}

#ifdef MOVED
// Has anything moved between the light and this point, in this frame's shutter, the last one's or between them? A point
// that moves itself is taken where the map sees it.
bool overlappedByDynamicCaster(ShadowTest test) {
    ivec2 texel =
        clamp(ivec2(floor(test.place * history.dynamicMaskSize)), ivec2(0), ivec2(history.dynamicMaskSize) - 1);
    return test.depth >= 0.9999 * mapDistance(texelFetch(dynamicMask, ivec3(texel, 0), 0).x);
}

bool moves(uint id) { return history.dynamicMaskSize > 0.0 && texelFetch(dynamicFlags, int(id)).x != 0u; }

// Where the pixel's surface point was one frame ago.
struct PastPoint {
    vec3 position;  // world space less the origin
    vec3 normal;
    vec3 eye;
    mat3 rays;
    float distance;  // along the ray of its image position; not positive: behind the camera
    vec2 pixel;      // position in the history, texel centres at whole numbers
};

PastPoint pastPointOf(Seen seen, uvec2 pixel) {
    float u = seen.receiver.time;
    MovingTriangle before = fetchTriangleFrom(previousPositions, seen.id);
    Receiver was = pointAt(before, seen.id, seen.receiver.barycentrics, u);
    PastPoint p;
    p.position = was.position;
    p.normal = cross(was.edge1, was.edge2);
    p.normal *= inversesqrt(max(dot(p.normal, p.normal), 1e-30));
    p.rays = previousRays(u);
    p.eye = previousEye(u);
    vec3 q = inverse(p.rays) * (was.position - p.eye);
    p.distance = q.z;
    // A pixel's history is that of its own sample position, so the displacement counts, not the position in the pixel.
    vec2 here = vec2(pixel) + cameraSample(pixel, seen.stratum, frame.seed, frame.pixelCentres).xy;
    p.pixel = vec2(pixel) + (q.xy / q.z * cameraView.size - here);
    p.pixel = roundedToTexel(p.pixel);
    return p;
}

// Equation 4 of Scherzer, Jeschke and Wimmer 2007, with the surface's own motion: the history of the surface point
// where it was one frame ago. Every one of the four texels must have seen the receiver's plane.
vec4 reprojected(Seen seen, uvec2 pixel) {
    PastPoint was = pastPointOf(seen, pixel);
    if (!(was.distance > 0.0)) return vec4(0.0);
    ivec2 corner = ivec2(floor(was.pixel));
    vec2 part = was.pixel - vec2(corner);
    vec2 sum = vec2(0.0);
    float weights = 0.0, oldest = 1e7;
    uint sure = HISTORY_MAX_SURE;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = corner + ivec2(i & 1, i >> 1);
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * ((i >> 1) == 0 ? 1.0 - part.y : part.y);
        bool inImage = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(cameraView.size)));
        if (!(weight > 0.0) || !inImage) continue;
        vec4 h = texelFetch(past, texel, 0);
        if (!plausible(h)) continue;
        vec2 offset = cameraSample(uvec2(texel), stratumOf(h), frame.seed, frame.pixelCentres).xy;
        vec2 at = (vec2(texel) + offset) / cameraView.size;
        vec3 point = was.eye + was.rays * vec3(at, 1.0) * h.z;
        float off = abs(dot(was.normal, point - was.position));
        if (off > history.threshold * was.distance) continue;
        h.xy *= min(1.0, history.memory / h.y);  // or a proven texel beside it would outweigh all others
        sum += weight * h.xy;
        weights += weight;
        oldest = min(oldest, ageOf(h));
        sure = min(sure, sureOf(h));
    }
    if (weights < 1e-3) return vec4(0.0);
    return vec4(sum / weights, was.distance, packedAge(oldest, sure, 0u));
}
#endif

// `share`: the sample's weight in the picture, 1 unless the shutter responds otherwise.
void addTest(inout PixelTests tests, ShadowTest test, uint stratum, float share) {
    float weight = max(confidenceWeight(test.confidence, history.exponent), 1e-12);
    // Where proof does not last it must not outweigh the other tests.
    if (history.triesTriangles != 0u && history.keepsProof == 0u) weight = 1.0 / history.weightScale;
    tests.testedStrata |= 1u << stratum;
    tests.sure = tests.sure && test.sure;
    tests.low = min(tests.low, test.place);
    tests.high = max(tests.high, test.place);
    tests.proven = tests.proven && test.proven;
    tests.count += share;
    tests.litSum += share * test.lit;
    tests.weightSum += share * weight;
    tests.weightedLit += share * (weight * test.lit);
}

// Tests every sample of the pixel that faces the light, and writes its own lit value.
PixelTests testPixel(uvec2 pixel) {
    PixelTests tests = noTests();
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        ivec3 place = ivec3(pixel, stratum);
        uint id = texelFetch(sampleIds, place, 0).x;
        if (id == NO_TRIANGLE) {
            imageStore(visibility, place, vec4(1.0));
            continue;
        }
#ifdef MOVED
        bool receiverMoves = moves(id);
        tests.receiverMoves = tests.receiverMoves || receiverMoves;
#endif
        MovingTriangle t = fetchTriangle(id);
        Receiver r = receiverOf(t, id, pixel, stratum);
        if (!facesLight(r)) {
            imageStore(visibility, place, vec4(0.0));
            continue;
        }
        ShadowTest test = testShadow(pointAt(t, id, r.barycentrics, history.instant), history.instant);
#ifdef MOVED
        bool overlapped = history.dynamicMaskSize > 0.0 && overlappedByDynamicCaster(test);
        if ((overlapped || receiverMoves) && test.guessedDark) test.lit = 0.0;
        tests.overlapped = tests.overlapped || overlapped;
#endif
        addTest(tests, test, stratum, shutterWeight(frame.response, frame.responseWidth, r.time));
        imageStore(visibility, place, vec4(test.lit));
        // The history is about the sample at the centre of the shutter, or the last before it that sees a surface to
        // test.
        if (!tests.seen.any || stratum <= frame.strata / 2u) tests.seen = Seen(true, id, stratum, r);
    }
    return tests;
}

// What the history holds of the pixel's surface; 0 where nothing of it may be used. `lit`: of this frame.
vec4 pastOf(PixelTests tests, uvec2 pixel, float lit) {
    if (history.hasPast == 0u) return vec4(0.0);
#ifdef MOVED
    vec4 before = reprojected(tests.seen, pixel);
    if (moves(tests.seen.id)) {
        // Its path through the light is unknown: the past may stay as long as the test agrees with it.
        if (!(abs(before.x - lit * before.y) <= 0.02 * before.y)) before = vec4(0.0);
        before.xy *= min(1.0, 2.0 / max(before.y, 1e-12));
    } else if (tests.overlapped) {
        before = vec4(0.0);
    }
#else
    vec4 before = texelFetch(past, ivec2(pixel), 0);
#endif
    return plausible(before) ? before : vec4(0.0);
}

// The pixel's merged lit value, and what the history holds of it from now on.
float mergedLit(PixelTests tests, vec4 before, float lit, out vec2 merged) {
    before.xy *= min(1.0, history.memory / max(before.y, 1e-12));
    vec2 sum = before.xy + history.weightScale * vec2(tests.weightedLit, tests.weightSum) / tests.count;
    sum *= min(1.0, HISTORY_MAX_WEIGHT / sum.y);
    merged = vec2(clamp(sum.x, 0.0, sum.y), sum.y);
    if (tests.proven) merged = vec2(0.0, HISTORY_PROVEN_WEIGHT);
    return clamp(0.5 + (merged.x / merged.y - 0.5) * history.sharpness, 0.0, 1.0);
}

// Darkens or brightens the samples in proportion, so that samples of different surfaces keep their differences.
void scaleSamples(uvec2 pixel, uint testedStrata, float lit, float shown) {
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        if ((testedStrata & (1u << stratum)) == 0u) continue;
        ivec3 place = ivec3(pixel, stratum);
        float own = imageLoad(visibility, place).x;
        own = shown < lit ? own * (shown / lit) : 1.0 - (1.0 - own) * ((1.0 - shown) / (1.0 - lit));
        imageStore(visibility, place, vec4(clamp(own, 0.0, 1.0)));
    }
}

#ifdef TRIES_TRIANGLES
// The re-test period of a pixel after `frames` tests with a static camera, of which the last `sure` were sure of every
// sample; and the cells of the light's image plane in which dynamic casters invalidate it.
uint retestPeriodOf(PixelTests tests, float frames, uint sure, bool isProven) {
    uint period = history.keepsProof == 0u && frames >= RETEST_DOUBT_AFTER ? RETEST_PERIOD_DOUBT : 0u;
    if (sure >= RETEST_SURE_AFTER) period = RETEST_PERIOD_SURE;
    if (isProven) period = RETEST_NEVER;
    if (history.mayConverge == 0u) period = 0u;
    uvec2 first = uvec2(clamp(tests.low * float(RETEST_SIDE), vec2(0.0), vec2(RETEST_SIDE - 1)));
    uvec2 last = uvec2(clamp(tests.high * float(RETEST_SIDE), vec2(0.0), vec2(RETEST_SIDE - 1)));
    return first.x | (first.y << RETEST_CELL_BITS) | (last.x << (2 * RETEST_CELL_BITS)) |
           (last.y << (3 * RETEST_CELL_BITS)) | (period << RETEST_PERIOD_SHIFT);
}
#endif

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    outputHistory = vec4(0.0);
    PixelTests tests = testPixel(pixel);
#ifdef TRIES_TRIANGLES
    outputPeriod = retestPeriodOf(tests, 0.0, 0u, !tests.receiverMoves);
#endif
    if (!tests.seen.any) return;
    float lit = tests.litSum / tests.count;
    vec4 before = pastOf(tests, pixel, lit);
    vec2 merged;
    float shown = mergedLit(tests, before, lit, merged);

    vec2 offset = cameraSample(pixel, tests.seen.stratum, frame.seed, frame.pixelCentres).xy;
    float distance = distanceOf(tests.seen.receiver, (vec2(pixel) + offset) / cameraView.size);
    bool hasPast = before.y > 0.0;
    float age = hasPast ? ageOf(before) + 1.0 : 1.0;
    // Beside dynamic triangles, and while the camera moves, no test is sure.
    bool disturbed = tests.receiverMoves || tests.overlapped || history.mayConverge == 0u;
    uint sureTests = tests.sure && !disturbed ? min(hasPast ? sureOf(before) + 1u : 1u, HISTORY_MAX_SURE) : 0u;
    outputHistory = vec4(merged, distance, packedAge(age, sureTests, tests.seen.stratum));
#ifdef TRIES_TRIANGLES
    float frames = disturbed ? 0.0 : min(age, float(history.round));
    outputPeriod = retestPeriodOf(tests, frames, sureTests, tests.proven && !disturbed);
#endif
    if (shown != lit) scaleSamples(pixel, tests.testedStrata, lit, shown);
}
