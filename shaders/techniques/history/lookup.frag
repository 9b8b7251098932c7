// All camera samples of a pixel against this frame's map; their lit share is merged with what earlier frames knew of
// the surface, and handed back to the samples so that the pixel's mean is the merged share.
// MOVED: the camera or something in the scene has moved since the frame before, so that the past lies elsewhere.
#include "techniques/history/map_test.glsl"

layout(binding = PAST_UNIT) uniform sampler2D past;
#ifdef MOVED
layout(binding = PREVIOUS_POSITIONS_UNIT) uniform samplerBuffer previousPositions;
layout(binding = MOVER_MASK_UNIT) uniform sampler2DArray moverMask;
#endif
layout(r32f, binding = 0) uniform image2DArray visibility;

// x: sum of weight times lit (as published: the smoothed lit). y: sum of weights; 0 where there is no past. z: distance of the
// surface along the ray of its image position. w: frames merged and the number of the stratum it was seen in.
layout(location = 0) out vec4 outputHistory;

struct Seen {
    bool any;
    uint id;
    uint stratum;
    Receiver receiver;
};

// Nothing that is not a number, not a share or not in front of the camera survives: every test fails for a NaN.
bool plausible(vec4 h) {
    return h.y > 0.0 && h.y <= HISTORY_PROVEN_WEIGHT && h.x >= 0.0 && h.x <= h.y * 1.00001 && h.z > 0.0 && h.z < 1e30 && h.w >= 0.0 && h.w < 1e7;
}

float ageOf(vec4 h) { return floor(h.w / float(1 << HISTORY_STRATUM_BITS)); }
uint stratumOf(vec4 h) { return uint(h.w) & uint((1 << HISTORY_STRATUM_BITS) - 1); }
float ageAndStratum(float age, uint stratum) { return min(age, 65535.0) * float(1 << HISTORY_STRATUM_BITS) + float(stratum); }

#ifdef MOVED
MovingTriangle fetchPrevious(uint id) {
    int first = int(id) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(previousPositions, first), b = texelFetch(previousPositions, first + 1),
         c = texelFetch(previousPositions, first + 2), d = texelFetch(previousPositions, first + 3),
         e = texelFetch(previousPositions, first + 4);
    return MovingTriangle(a.xyz, vec3(a.w, b.xy), vec3(b.zw, c.x), c.yzw, d.xyz, vec3(d.w, e.xy), e.z != 0.0, uint(e.w));
}

mat3 previousRays(float u) { return mat3(history.previousRaysOpen) * (1.0 - u) + mat3(history.previousRaysClose) * u; }

// Did anything move between the light and this point, in this frame's shutter, the last one's or between them?
bool touchedByMover(Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    ivec2 texel = clamp(ivec2(floor(m.position * history.moverMaskSize)), ivec2(0), ivec2(history.moverMaskSize) - 1);
    return m.depth >= 0.9999 * mapDistance(texelFetch(moverMask, ivec3(texel, 0), 0).x);
}

bool sameTriangle(MovingTriangle a, MovingTriangle b) {
    return a.open0 == b.open0 && a.open1 == b.open1 && a.open2 == b.open2 && a.close0 == b.close0 && a.close1 == b.close1 &&
           a.close2 == b.close2 && a.open0 == a.close0 && a.open1 == a.close1 && a.open2 == a.close2;
}

// Equation 4, with the surface's own motion: where the surface point was one frame ago, and what was known of it. As
// published only the camera is followed, and the distance is compared; else every one of the four texels must have seen
// the receiver's plane.
vec4 reprojected(Seen seen, uvec2 pixel, out bool receiverMoves) {
    bool published = history.asPublished != 0u;
    float u = seen.receiver.time;
    MovingTriangle now = fetchTriangle(seen.id), before = now;
    if (!published) before = fetchPrevious(seen.id);
    receiverMoves = !sameTriangle(now, before) && !published;
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
    }
    if (published && (weights < 0.999 || sum.z > history.threshold * q.z)) return vec4(0.0);
    if (weights < 1e-3) return vec4(0.0);
    return vec4(sum.xy / weights, q.z, oldest * float(1 << HISTORY_STRATUM_BITS));
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

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    outputHistory = vec4(0.0);
    Seen seen;
    seen.any = false;
    bool touched = false;
    float tested = 0.0, litSum = 0.0, weightSum = 0.0, weightedLit = 0.0;
    uint facing = 0u;
    bool proven = history.keepsProof != 0u;
#ifndef MOVED
    if (proven && history.hasPast != 0u) {
        vec4 before = texelFetch(past, ivec2(pixel), 0);
        if (plausible(before) && before.y == HISTORY_PROVEN_WEIGHT) {
            outputHistory = vec4(before.xyz, ageAndStratum(ageOf(before) + 1.0, stratumOf(before)));
            imageStore(visibility, ivec3(pixel, 0), vec4(0.0));
            return;
        }
    }
#endif
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        ivec3 place = ivec3(pixel, stratum);
        uint id = texelFetch(sampleIds, place, 0).x;
        if (id == NO_TRIANGLE) {
            imageStore(visibility, place, vec4(1.0));
            continue;
        }
        MovingTriangle t = fetchTriangle(id);
        Receiver r = receiverOf(t, id, pixel, stratum);
        if (!facesLight(r)) {
            imageStore(visibility, place, vec4(0.0));
            continue;
        }
        bool rests = true;
#ifdef MOVED
        if (history.moverMaskSize > 0.0) {
            touched = touched || touchedByMover(r);
            rests = !touched && sameTriangle(t, fetchPrevious(id));
        }
#endif
        ShadowTest test = testShadow(pointAt(t, id, r.barycentrics, history.instant), history.instant, rests);
        float weight = max(confidenceWeight(test.confidence, history.exponent), 1e-12);
        // Where proof can't stay it must not outweigh the other answers.
        if (history.triesTriangles != 0u && history.keepsProof == 0u) weight = 1.0 / history.weightScale;
        facing |= 1u << stratum;
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
    if (!seen.any) return;
    float lit = litSum / tested, weight = weightSum / tested;

    vec4 before = vec4(0.0);
    if (history.hasPast != 0u) {
#ifdef MOVED
        bool receiverMoves;
        before = reprojected(seen, pixel, receiverMoves);
        if (receiverMoves) {
            // Its way through the light is unknown: the past may stay as long as the test agrees with it.
            if (!(abs(before.x - lit * before.y) <= 0.02 * before.y)) before = vec4(0.0);
            before.xy *= min(1.0, 2.0 / max(before.y, 1e-12));
        } else if (touched && history.asPublished == 0u) {
            before = vec4(0.0);
        }
#else
        before = texelFetch(past, ivec2(pixel), 0);
#endif
        if (!plausible(before)) before = vec4(0.0);
    }

    bool hasPast = before.y > 0.0;
    float shown = lit;
    if (history.asPublished != 0u) {
        shown = hasPast ? smoothed(before.x, lit, weight) : lit;
        outputHistory.xy = vec2(unpackHalf2x16(packHalf2x16(vec2(shown, 0.0))).x, 1.0);
        shown = outputHistory.x;
    } else {
        before.xy *= min(1.0, history.memory / max(before.y, 1e-12));
        vec2 sum = before.xy + history.weightScale * vec2(weightedLit, weightSum) / tested;
        sum *= min(1.0, HISTORY_LARGEST_WEIGHT / sum.y);
        outputHistory.xy = vec2(clamp(sum.x, 0.0, sum.y), sum.y);
        if (proven) outputHistory.xy = vec2(0.0, HISTORY_PROVEN_WEIGHT);
        shown = clamp(0.5 + (outputHistory.x / outputHistory.y - 0.5) * history.sharpness, 0.0, 1.0);
    }
    vec2 position = (vec2(pixel) + samplePattern(pixel, seen.stratum, frame.seed, SALT_CAMERA).xy) / cameraView.size;
    outputHistory.z = distanceOf(seen.receiver, position);
    outputHistory.w = ageAndStratum(hasPast ? ageOf(before) + 1.0 : 1.0, seen.stratum);

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
