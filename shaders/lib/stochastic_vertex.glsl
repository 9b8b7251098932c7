// What the two ways of covering a moving triangle (a point, a rectangle) have in common.
//
// VIEW_LIGHT: draw for the light instead of the camera. VIEW_TURNS, VIEW_ORTHOGRAPHIC: kind of view.
#include "lib/blocks.glsl"
#include "lib/triangle_texels.glsl"
#include "shared/moving_triangle.shared.h"
#include "shared/swept_bounds.shared.h"

#ifdef VIEW_LIGHT
#define view lightView
#else
#define view cameraView
#endif

uniform uint stratum;
uniform float stratumLength;  // u

out gl_PerVertex {
    vec4 gl_Position;
    float gl_PointSize;
};

flat out vec4 open0;  // view coordinates of vertex 0 at u = 0; w: 1 if the triangle is two-sided
flat out vec3 open1;
flat out vec3 open2;
flat out vec3 close0;
flat out vec3 close1;
flat out vec3 close2;
flat out uint triangleId;

// Whole pixels that may hold a sample of the triangle during this stratum: [low, high), low >= high for none.
struct PixelBounds {
    ivec2 low, high;
};

vec3 facingVector(vec3 v) {
#ifdef VIEW_ORTHOGRAPHIC
    return vec3(v.xy, 1.0);
#else
    return v;
#endif
}

void outputTriangle(MovingTriangle t, uint id) {
    VertexMotion world = VertexMotion(t.open0, t.open1, t.open2, t.close0, t.close1, t.close2);
    VertexMotion v = inView(world, view.viewFromWorldOpen, view.viewFromWorldClose);
    open0 = vec4(v.open0, t.doubleSided ? 1.0 : 0.0);
    open1 = v.open1;
    open2 = v.open2;
    close0 = v.close0;
    close1 = v.close1;
    close2 = v.close2;
    triangleId = id;
}

// Where in the image the triangle may be seen during this stratum.
SweptBounds stratumBounds(bool doubleSided) {
    float begin = frame.timeBase + float(stratum) * stratumLength;
    float end = begin + stratumLength;
    vec3 a0 = mix(open0.xyz, close0, begin), b0 = mix(open0.xyz, close0, end);
    vec3 a1 = mix(open1, close1, begin), b1 = mix(open1, close1, end);
    vec3 a2 = mix(open2, close2, begin), b2 = mix(open2, close2, end);
#if defined(VIEW_TURNS)
    mat4 raysA = view.raysOpen * (1.0 - begin) + view.raysClose * begin;
    mat4 raysB = view.raysOpen * (1.0 - end) + view.raysClose * end;
    SweptBounds bounds = sweptBoundsTurning(a0, a1, a2, b0, b1, b2, raysA, raysB);
#elif defined(VIEW_ORTHOGRAPHIC)
    SweptBounds bounds = sweptBoundsOrthographic(a0, a1, a2, b0, b1, b2);
#else
    SweptBounds bounds = sweptBoundsPerspective(a0, a1, a2, b0, b1, b2, view.nearDistance);
#endif
#ifndef VIEW_LIGHT
    // One-sided triangles that face away all through the stratum are never seen.
    vec4 facing = determinantCoefficients(facingVector(a0), facingVector(a1), facingVector(a2), facingVector(b0),
                                          facingVector(b1), facingVector(b2));
    if (!doubleSided && all(lessThan(facing, vec4(0.0)))) bounds.high = bounds.low - 1.0;
#endif
    return bounds;
}

PixelBounds coverTriangle(MovingTriangle t, uint id) {
    outputTriangle(t, id);
    SweptBounds bounds = stratumBounds(t.doubleSided);
    // A slack of 1/64 pixel covers the rounding of the projection; the fragments test exactly.
    const float slack = 1.0 / 64.0;
    vec2 low = clamp(bounds.low * view.size - slack, vec2(-1.0), view.size + 1.0);
    vec2 high = clamp(bounds.high * view.size + slack, vec2(-1.0), view.size + 1.0);
    PixelBounds pixels;
    pixels.low = max(ivec2(floor(low)), ivec2(0));
    pixels.high = min(ivec2(floor(high)) + 1, ivec2(view.size));
#ifdef VIEW_LIGHT
    // A map is sampled at its texels' centres: those outside the bounds cannot be covered.
    pixels.low = max(ivec2(ceil(low - 0.5)), ivec2(0));
    pixels.high = min(ivec2(floor(high - 0.5)) + 1, ivec2(view.size));
#endif
    return pixels;
}
