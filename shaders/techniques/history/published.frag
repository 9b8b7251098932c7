// Scherzer, Jeschke and Wimmer 2007 as they have it: each fragment's shadow map test is smoothed with the history of
// the point that it shows. A texel of the history is what they store, in half floats: x the smoothed test, y the depth.
// z is for the views alone: how many frames the test has been smoothed over.
#include "techniques/history/cameras.glsl"
#include "techniques/history/map_test.glsl"

uniform sampler2D past;
layout(r32f) uniform image2DArray visibility;

layout(location = 0) out vec4 outputHistory;

// What a pixel shows. The paper has one sample a pixel; of several, the mean of their tests. Those that face away from
// the light have a test as well: every fragment has a place in the history (3.1, "containing for each fragment").
struct Fragment {
    bool any;
    uint stratum;  // of the sample at the shutter's centre, or the last before it that sees a surface
    Receiver receiver;
    float f;      // the tests' mean result
    float w;      // equation 6
    uint facing;  // strata that face the light, a bit each
};

Fragment testedFragment(uvec2 pixel) {
    Fragment fragment;
    fragment.any = false;
    fragment.f = fragment.w = 0.0;
    fragment.facing = 0u;
    float count = 0.0;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        ivec3 place = ivec3(pixel, stratum);
        uint id = texelFetch(sampleIds, place, 0).x;
        imageStore(visibility, place, vec4(id == NO_TRIANGLE ? 1.0 : 0.0));
        if (id == NO_TRIANGLE) continue;
        MovingTriangle t = fetchTriangle(id);
        Receiver r = receiverOf(t, id, pixel, stratum);
        ShadowTest test = testShadow(pointAt(t, id, r.barycentrics, history.instant), history.instant);
        fragment.f += test.lit;
        fragment.w += confidenceWeight(test.confidence, history.exponent);
        count += 1.0;
        if (facesLight(r)) fragment.facing |= 1u << stratum;
        if (!fragment.any || stratum <= frame.strata / 2u) {
            fragment.any = true;
            fragment.stratum = stratum;
            fragment.receiver = r;
        }
    }
    fragment.f /= max(count, 1.0);
    fragment.w /= max(count, 1.0);
    return fragment;
}

float asHalf(float value) { return unpackHalf2x16(packHalf2x16(vec2(value, 0.0))).x; }

// The depth as it is after the perspective division: over a plane it is linear in the image, so that filtering keeps it
// exact. Reversed, as everywhere here: a half float is then as fine, relatively, far away as near.
float depthOf(float distance, float nearDistance) { return nearDistance / distance; }

// Bilinear filtering of the history, with clamped borders, as hardware does it (3.2), but with whole weights.
vec3 filteredPast(vec2 pixel) {
    vec2 corner = floor(pixel), part = pixel - corner;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        float weight = ((i & 1) == 0 ? 1.0 - part.x : part.x) * ((i >> 1) == 0 ? 1.0 - part.y : part.y);
        if (!(weight > 0.0)) continue;
        ivec2 texel = clamp(ivec2(corner) + ivec2(i & 1, i >> 1), ivec2(0), ivec2(cameraView.size) - 1);
        sum += weight * texelFetch(past, texel, 0).xyz;
    }
    return sum;
}

// Equation 4: the fragment's point where the camera one frame ago saw it; x: s(n-1), z: its frames. z is 0 where the
// fragment is new: outside the history, or farther from what is there than the threshold (3.2).
vec3 reprojected(Fragment fragment, uvec2 pixel) {
    if (history.hasPast == 0u) return vec3(0.0);
    float u = fragment.receiver.time;
    vec3 q = inverse(previousRays(u)) * (fragment.receiver.position - previousEye(u));
    if (!(q.z > 0.0)) return vec3(0.0);
    // With samples at pixel centres, that is the position itself.
    vec2 here = vec2(pixel) + cameraSample(pixel, fragment.stratum, frame.seed, frame.pixelCentres).xy;
    vec2 place = roundedToTexel(vec2(pixel) + (q.xy / q.z * cameraView.size - here));
    if (any(lessThan(place, vec2(-0.5))) || any(greaterThan(place, cameraView.size - 0.5))) return vec3(0.0);
    vec3 before = filteredPast(place);
    float depth = depthOf(q.z, history.previousNear);
    bool same = abs(before.y - depth) <= history.threshold * depth;
    bool plausible = before.x >= 0.0 && before.x <= 1.00001 && before.z > 0.0;  // every comparison fails for a NaN
    return same && plausible ? before : vec3(0.0);
}

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    outputHistory = vec4(0.0);
    Fragment fragment = testedFragment(pixel);
    if (!fragment.any) return;
    vec3 before = reprojected(fragment, pixel);
    float s = asHalf(min(before.z > 0.0 ? smoothed(before.x, fragment.f, fragment.w) : fragment.f, 1.0));
    vec2 offset = cameraSample(pixel, fragment.stratum, frame.seed, frame.pixelCentres).xy;
    float distance = distanceOf(fragment.receiver, (vec2(pixel) + offset) / cameraView.size);
    float frames = min(floor(before.z + 0.5) + 1.0, 2048.0);  // up to which half floats count
    outputHistory = vec4(s, asHalf(depthOf(distance, cameraView.nearDistance)), frames, 0.0);
    for (uint stratum = 0u; stratum < frame.strata; ++stratum)
        if ((fragment.facing & (1u << stratum)) != 0u) imageStore(visibility, ivec3(pixel, stratum), vec4(s));
}
