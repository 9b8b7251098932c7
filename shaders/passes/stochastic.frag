// Does the sample of this pixel and stratum lie in the moving triangle at its own time? Exact per sample: the cover
// drawn by the vertex shader only has to be large enough.
//
// OUTPUT_ID: write the triangle's number. OUTPUT_DYNAMIC_PIXELS: and 1 where a triangle is seen in any stratum.
// OUTPUT_DEPTH_RATE: write how fast the depth changes that this pixel sees of the triangle.
// OUTPUT_DEPTH_VELOCITY: write how fast the depth changes of the point of the triangle that it sees.
// OUTPUT_MOTION: write how fast that point moves in view coordinates, and the sample's time.
// CUTOUTS: as in lib/cutouts.glsl.
// TIME_PATTERN: of a map, the side of a pattern of fixed times (sample_pattern.shared.h) instead of random ones.
#include "lib/blocks.glsl"
#include "lib/cutouts.glsl"
#include "shared/moving_triangle.shared.h"
#include "shared/sample_pattern.shared.h"

#ifdef VIEW_LIGHT
#define view lightView
#else
#define view cameraView
#endif

uniform uint stratum;
uniform float stratumLength;  // u
uniform int firstRow;         // of the view that the target holds

flat in vec4 open0;
flat in vec3 open1;
flat in vec3 open2;
flat in vec3 close0;
flat in vec3 close1;
flat in vec3 close2;
flat in uint triangleId;

#if defined(OUTPUT_ID)
layout(location = 0) out uint outputId;
#ifdef OUTPUT_DYNAMIC_PIXELS
layout(location = 1) out float outputDynamicPixel;
#endif
#elif defined(OUTPUT_DEPTH_RATE) || defined(OUTPUT_DEPTH_VELOCITY)
layout(location = 0) out float outputDepthChange;
#elif defined(OUTPUT_MOTION)
layout(location = 0) out vec4 outputMotion;
#endif

struct Sample {
    vec2 position;  // in the image
    float u;
};

Sample sampleOf(uvec2 pixel) {
#ifdef VIEW_LIGHT
#ifdef TIME_PATTERN
    vec3 pattern = vec3(phaseTime(texelPhase(pixel, uint(TIME_PATTERN)), uint(TIME_PATTERN)));
#else
    vec3 pattern = samplePattern(pixel, frame.firstStratum + stratum, frame.seed, SALT_LIGHT);
#endif
    pattern.xy = vec2(0.5);  // a map is sampled at its texels' centres
#else
    vec3 pattern = cameraSample(pixel, frame.firstStratum + stratum, frame.seed, frame.pixelCentres);
#endif
    float u = sampleTime(frame.timeBase, stratumLength, stratum, pattern.z);
    return Sample((vec2(pixel) + pattern.xy) / view.size, u);
}

// The triangle's vertices at one time, in view coordinates.
struct Vertices {
    vec3 v0, v1, v2;
};

// Edge functions, and the length of the ray along the view's axis.
vec3 edgesOf(Vertices v, Sample s, out float rayLength) {
    rayLength = 1.0;
#if defined(VIEW_ORTHOGRAPHIC)
    precise vec3 e = edgeFunctions(v.v0.xy - s.position, v.v1.xy - s.position, v.v2.xy - s.position);
#elif defined(VIEW_TURNS)
    vec3 ray =
        mix((view.raysOpen * vec4(s.position, 1.0, 0.0)).xyz, (view.raysClose * vec4(s.position, 1.0, 0.0)).xyz, s.u);
    rayLength = ray.z;
    precise vec3 e = edgeFunctions(v.v0.xy * ray.z - ray.xy * v.v0.z, v.v1.xy * ray.z - ray.xy * v.v1.z,
                                   v.v2.xy * ray.z - ray.xy * v.v2.z);
#else
    precise vec3 e =
        edgeFunctions(v.v0.xy - s.position * v.v0.z, v.v1.xy - s.position * v.v1.z, v.v2.xy - s.position * v.v2.z);
#endif
    return e;
}

#ifdef OUTPUT_DEPTH_RATE
// Change of the depth at the sample's position per u. Within the stratum the depth can't change by more than the
// vertices' depths differ in it.
float depthRate(Vertices v, Sample s) {
    vec3 d0 = close0 - open0.xyz, d1 = close1 - open1, d2 = close2 - open2;
    vec3 z = vec3(v.v0.z, v.v1.z, v.v2.z), zRate = vec3(d0.z, d1.z, d2.z);
    vec2 p = s.position;
#ifdef VIEW_ORTHOGRAPHIC
    float rate = depthRateAtPlace(v.v0.xy - p, v.v1.xy - p, v.v2.xy - p, d0.xy, d1.xy, d2.xy, z, zRate);
#else
    float rate = depthRateAtPlace(v.v0.xy - p * v.v0.z, v.v1.xy - p * v.v1.z, v.v2.xy - p * v.v2.z, d0.xy - p * d0.z,
                                  d1.xy - p * d1.z, d2.xy - p * d2.z, z, zRate);
#endif
    float begin = frame.timeBase + float(stratum) * stratumLength - s.u, end = begin + stratumLength;
    vec3 first = z + begin * zRate, last = z + end * zRate, low = min(first, last), high = max(first, last);
    float most = max(max(high.x, high.y), high.z) - min(min(low.x, low.y), low.z);
    return clamp(rate, -most / stratumLength, most / stratumLength);
}
#endif

void main() {
    Sample s = sampleOf(uvec2(gl_FragCoord.xy) + uvec2(0u, uint(firstRow)));
    Vertices v = Vertices(mix(open0.xyz, close0, s.u), mix(open1, close1, s.u), mix(open2, close2, s.u));
    float rayLength;
    precise vec3 e = edgesOf(v, s, rayLength);
    float sum = e.x + e.y + e.z;
    bool front = min(min(e.x, e.y), e.z) >= 0.0 && sum > 0.0;
    bool back = max(max(e.x, e.y), e.z) <= 0.0 && sum < 0.0;
#ifndef VIEW_LIGHT
    back = back && open0.w != 0.0;
#endif
    if (!(front || back)) discard;
    if (!cutoutCovers(triangleId, e)) discard;
    float distance = dot(e, vec3(v.v0.z, v.v1.z, v.v2.z)) / sum;
#if defined(VIEW_TURNS)
    distance /= rayLength;
#endif
#if defined(VIEW_ORTHOGRAPHIC)
    if (!(distance >= 0.0 && distance <= view.farDistance)) discard;
    gl_FragDepth = 1.0 - distance / view.farDistance;
#else
    if (!(distance > view.nearDistance)) discard;
    gl_FragDepth = view.nearDistance / distance;  // reversed: 1 at the near plane, 0 infinitely far
#endif
#if defined(OUTPUT_ID)
    outputId = triangleId;
#ifdef OUTPUT_DYNAMIC_PIXELS
    outputDynamicPixel = 1.0;
#endif
#elif defined(OUTPUT_DEPTH_RATE)
    outputDepthChange = depthRate(v, s);
#elif defined(OUTPUT_DEPTH_VELOCITY)
    outputDepthChange = dot(e, vec3(close0.z - open0.z, close1.z - open1.z, close2.z - open2.z)) / sum;
#elif defined(OUTPUT_MOTION)
    vec3 motion = e.x * (close0 - open0.xyz) + e.y * (close1 - open1) + e.z * (close2 - open2);
    outputMotion = vec4(motion / sum, s.u);
#endif
}
