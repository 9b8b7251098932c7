// All camera samples of a pixel against this frame's map; their lit share is merged with what earlier frames knew of
// the surface, and handed back to the samples so that the pixel's mean is the merged share.
// MOVED: the camera or something in the scene has moved since the frame before, so that the past lies elsewhere.
// TRIES_TRIANGLES: as in map_test.glsl; then it is said as well how long the pixel may rest.
#include "techniques/history/map_test.glsl"
#include "techniques/history/texel.glsl"

layout(early_fragment_tests) in;  // or pixels that rest would be drawn

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

struct Seen {
    bool any;
    uint id;
    uint stratum;
    Receiver receiver;
};

#ifdef MOVED
MovingTriangle fetchPrevious(uint id) {
    int first = int(id) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(previousPositions, first), b = texelFetch(previousPositions, first + 1),
         c = texelFetch(previousPositions, first + 2), d = texelFetch(previousPositions, first + 3),
         e = texelFetch(previousPositions, first + 4);
    return MovingTriangle(a.xyz, vec3(a.w, b.xy), vec3(b.zw, c.x), c.yzw, d.xyz, vec3(d.w, e.xy), e.z != 0.0, uint(e.w));
}

mat3 previousRays(float u) { return mat3(history.previousRaysOpen) * (1.0 - u) + mat3(history.previousRaysClose) * u; }

// Did anything move between the light and this point, in this frame's shutter, the last one's or between them? A point that moves
// itself is taken where the map sees it.
bool overlappedByDynamicCaster(ShadowTest test) {
    ivec2 texel = clamp(ivec2(floor(test.place * history.dynamicMaskSize)), ivec2(0), ivec2(history.dynamicMaskSize) - 1);
    return test.depth >= 0.9999 * mapDistance(texelFetch(dynamicMask, ivec3(texel, 0), 0).x);
}

bool moves(uint id) { return history.dynamicMaskSize > 0.0 && texelFetch(dynamicFlags, int(id)).x != 0u; }

// Equation 4, with the surface's own motion: where the surface point was one frame ago, and what was known of it. As
// published only the camera is followed, and the distance is compared; else every one of the four texels must have seen
// the receiver's plane.
vec4 reprojected(Seen seen, uvec2 pixel, out bool receiverMoves) {
    bool published = setting.as_published;
    float u = seen.receiver.time;
    MovingTriangle before = fetchTriangle(seen.id);
    if (!published) before = fetchPrevious(seen.id);
    receiverMoves = moves(seen.id);  // as published the mask is not made
    Receiver was = pointAt(before, seen.id, seen.receiver.barycentrics, u);
    mat3 rays = previousRays(u);
    vec3 eye = mix(history.previousEyeOpen.xyz, history.previousEyeClose.xyz, u);
    vec3 q = inverse(rays) * (was.position - eye);
    if (!(q.z > 0.0)) return vec4(0.0);
    // A pixel's history is that of its own sample position, so the way is what counts, not the place inside the pixel.
    vec2 here = vec2(pixel) + samplePattern(pixel, seen.stratum, frame.seed, SALT_CAMERA).xy;
    vec2 position = vec2(pixel) + (q.xy / q.z * cameraView.size - here);
    // Rounding must not make a camera that stands still read its neighbours.
    vec2 nearest = floor(position + 0.5);
    if (all(lessThan(abs(position - nearest), vec2(1e-3)))) position = nearest;
    ivec2 corner = ivec2(floor(position));
    vec2 part = position - vec2(corner);
    vec3 normal = cross(was.edge1, was.edge2);
    normal *= inversesqrt(max(dot(normal, normal), 1e-30));
    vec4 sum = vec4(0.0);
    float weights = 0.0, oldest = 1e7;
    uint sure = HISTORY_MAX_SURE;
    for (int i = 0; i < 4; ++i) {
        ivec2 texel = corner + ivec2(i & 1, i >> 1);
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * ((i >> 1) == 0 ? 1.0 - part.y : part.y);
        if (!(weight > 0.0) || any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(cameraView.size)))) continue;
        vec4 h = texelFetch(past, texel, 0);
        if (!plausible(h)) continue;
        vec2 at = (vec2(texel) + samplePattern(uvec2(texel), stratumOf(h), frame.seed, SALT_CAMERA).xy) / cameraView.size;
        vec3 point = eye + rays * vec3(at, 1.0) * h.z;
        float off = published ? abs(h.z - q.z) : abs(dot(normal, point - was.position));
        if (!published && off > history.threshold * q.z) continue;
        if (!published) h.xy *= min(1.0, history.memory / h.y);  // or what is proven next to it would outweigh all
        sum += weight * vec4(h.xy, off, 0.0);
        weights += weight;
        oldest = min(oldest, ageOf(h));
        sure = min(sure, sureOf(h));
    }
    if (published && (weights < 0.999 || sum.z > history.threshold * q.z)) return vec4(0.0);
    if (weights < 1e-3) return vec4(0.0);
    return vec4(sum.xy / weights, q.z, packedAge(oldest, sure, 0u));
}
#endif

// Distance along the ray of its image position, as the camera measures it at the receiver's time.
float distanceOf(Receiver r, vec2 position) {
    vec3 v = mix((cameraView.viewFromWorldOpen * vec4(r.position, 1.0)).xyz, (cameraView.viewFromWorldClose * vec4(r.position, 1.0)).xyz, r.time);
#ifdef CAMERA_TURNS
    return v.z / mix((cameraView.raysOpen * vec4(position, 1.0, 0.0)).xyz, (cameraView.raysClose * vec4(position, 1.0, 0.0)).xyz, r.time).z;
#else
    return v.z;
#endif
}

#ifdef TRIES_TRIANGLES
// For how long a pixel rests, after `tests` with a camera at rest of which the last `sure` were sure of every sample, and where it has to be woken.
uint retestPeriodOf(float tests, uint sure, bool isProven, vec2 low, vec2 high) {
    uint period = history.keepsProof == 0u && tests >= RETEST_DOUBT_AFTER ? RETEST_PERIOD_DOUBT : 0u;
    if (sure >= RETEST_SURE_AFTER) period = RETEST_PERIOD_SURE;
    if (isProven) period = RETEST_NEVER;
    if (history.mayConverge == 0u) period = 0u;
    uvec2 first = uvec2(clamp(low * float(RETEST_SIDE), vec2(0.0), vec2(RETEST_SIDE - 1)));
    uvec2 last = uvec2(clamp(high * float(RETEST_SIDE), vec2(0.0), vec2(RETEST_SIDE - 1)));
    return first.x | (first.y << RETEST_CELL_BITS) | (last.x << (2 * RETEST_CELL_BITS)) | (last.y << (3 * RETEST_CELL_BITS)) | (period << RETEST_PERIOD_SHIFT);
}
#endif

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    outputHistory = vec4(0.0);
    Seen seen;
    seen.any = false;
    bool dynamicPixels = false, anyMoves = false, sure = true;
    vec2 low = vec2(1.0), high = vec2(0.0);  // nowhere: the last cell before the first
    float tested = 0.0, litSum = 0.0, weightSum = 0.0, weightedLit = 0.0;
    uint facing = 0u;
    bool proven = history.keepsProof != 0u;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        ivec3 place = ivec3(pixel, stratum);
        uint id = texelFetch(sampleIds, place, 0).x;
        if (id == NO_TRIANGLE) {
            imageStore(visibility, place, vec4(1.0));
            continue;
        }
#ifdef MOVED
        bool receiverMoves = moves(id);
        anyMoves = anyMoves || receiverMoves;
#endif
        MovingTriangle t = fetchTriangle(id);
        Receiver r = receiverOf(t, id, pixel, stratum);
        if (!facesLight(r)) {
            imageStore(visibility, place, vec4(0.0));
            continue;
        }
        ShadowTest test = testShadow(pointAt(t, id, r.barycentrics, history.instant), history.instant);
#ifdef MOVED
        bool overlappedHere = history.dynamicMaskSize > 0.0 && overlappedByDynamicCaster(test);
        if ((overlappedHere || receiverMoves) && test.guessedDark) test.lit = 0.0;
        dynamicPixels = dynamicPixels || overlappedHere;
#endif
        float weight = max(confidenceWeight(test.confidence, history.exponent), 1e-12);
        // Where proof can't stay it must not outweigh the other answers.
        if (history.triesTriangles != 0u && history.keepsProof == 0u) weight = 1.0 / history.weightScale;
        facing |= 1u << stratum;
        sure = sure && test.sure;
        low = min(low, test.place);
        high = max(high, test.place);
        proven = proven && test.proven;
        tested += 1.0;
        litSum += test.lit;
        weightSum += weight;
        weightedLit += weight * test.lit;
        imageStore(visibility, place, vec4(test.lit));
        // The pixel is known by the sample in the middle of the shutter, or the last before it that sees a surface to test.
        if (!seen.any || stratum <= frame.strata / 2u) {
            seen.any = true;
            seen.id = id;
            seen.stratum = stratum;
            seen.receiver = r;
        }
    }
#ifdef TRIES_TRIANGLES
    outputPeriod = retestPeriodOf(0.0, 0u, !anyMoves, low, high);
#endif
    if (!seen.any) return;
    float lit = litSum / tested, weight = weightSum / tested;

    vec4 before = vec4(0.0);
    if (history.hasPast != 0u) {
#ifdef MOVED
        bool knownMoves;
        before = reprojected(seen, pixel, knownMoves);
        if (knownMoves) {
            // Its way through the light is unknown: the past may stay as long as the test agrees with it.
            if (!(abs(before.x - lit * before.y) <= 0.02 * before.y)) before = vec4(0.0);
            before.xy *= min(1.0, 2.0 / max(before.y, 1e-12));
        } else if (dynamicPixels && !setting.as_published) {
            before = vec4(0.0);
        }
#else
        before = texelFetch(past, ivec2(pixel), 0);
#endif
        if (!plausible(before)) before = vec4(0.0);
    }

    bool hasPast = before.y > 0.0;
    float shown = lit;
    if (setting.as_published) {
        shown = hasPast ? smoothed(before.x, lit, weight) : lit;
        outputHistory.xy = vec2(unpackHalf2x16(packHalf2x16(vec2(shown, 0.0))).x, 1.0);
        shown = outputHistory.x;
    } else {
        before.xy *= min(1.0, history.memory / max(before.y, 1e-12));
        vec2 sum = before.xy + history.weightScale * vec2(weightedLit, weightSum) / tested;
        sum *= min(1.0, HISTORY_MAX_WEIGHT / sum.y);
        outputHistory.xy = vec2(clamp(sum.x, 0.0, sum.y), sum.y);
        if (proven) outputHistory.xy = vec2(0.0, HISTORY_PROVEN_WEIGHT);
        shown = clamp(0.5 + (outputHistory.x / outputHistory.y - 0.5) * history.sharpness, 0.0, 1.0);
    }
    vec2 position = (vec2(pixel) + samplePattern(pixel, seen.stratum, frame.seed, SALT_CAMERA).xy) / cameraView.size;
    outputHistory.z = distanceOf(seen.receiver, position);
    float age = hasPast ? ageOf(before) + 1.0 : 1.0;
    // Beside what moves, and while the camera does, a pixel can't know.
    bool disturbed = anyMoves || dynamicPixels || history.mayConverge == 0u;
    uint sureTests = sure && !disturbed ? min(hasPast ? sureOf(before) + 1u : 1u, HISTORY_MAX_SURE) : 0u;
    outputHistory.w = packedAge(age, sureTests, seen.stratum);
#ifdef TRIES_TRIANGLES
    outputPeriod = retestPeriodOf(disturbed ? 0.0 : min(age, float(history.round)), sureTests, proven && !disturbed, low, high);
#endif

    if (shown == lit) return;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        if ((facing & (1u << stratum)) == 0u) continue;
        ivec3 place = ivec3(pixel, stratum);
        float own = imageLoad(visibility, place).x;
        // Darker or brighter in proportion, so that samples of different surfaces keep their differences.
        own = shown < lit ? own * (shown / lit) : 1.0 - (1.0 - own) * ((1.0 - shown) / (1.0 - lit));
        imageStore(visibility, place, vec4(clamp(own, 0.0, 1.0)));
    }
}
