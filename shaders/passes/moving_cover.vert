// Covers, cheaply, all texels that a moving triangle may overlap during the shutter; the fragment shaders decide
// exactly.
//
// COVER_POINTS: one point per triangle, for small sweeps. Else a rectangle of four indexed vertices, along the motion
// where that is smaller: a triangle that moves far sweeps a narrow band of its bounding box.
#include "lib/blocks.glsl"
#include "lib/triangle_texels.glsl"
#include "shared/frame_blocks.shared.h"
#include "shared/swept_bounds.shared.h"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
uniform usamplerBuffer coverTriangles;

out gl_PerVertex {
    vec4 gl_Position;
    float gl_PointSize;
};

// The triangle in view coordinates.
flat out vec3 open0;
flat out vec3 open1;
flat out vec3 open2;
flat out vec3 close0;
flat out vec3 close1;
flat out vec3 close2;
flat out uint triangleId;
flat out uint nonTranslating;  // 1: the vertices do not all move alike, by more than rounding

// Rounding of the projection and of the rasteriser's grid, in texels.
const float SLACK = 1.0 / 32.0;

vec2 inTexels(vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return v.xy * lightView.size;
#else
    return v.xy / v.z * lightView.size;
#endif
}

void outputTriangle(uint id) {
    VertexMotion v =
        inView(fetchMotion(trianglePositions, id, true), lightView.viewFromWorldOpen, lightView.viewFromWorldClose);
    open0 = v.open0;
    open1 = v.open1;
    open2 = v.open2;
    close0 = v.close0;
    close1 = v.close1;
    close2 = v.close2;
    triangleId = id;
    vec3 motion0 = close0 - open0, turn1 = abs(close1 - open1 - motion0), turn2 = abs(close2 - open2 - motion0);
    vec3 reach = max(max(max(abs(open0), abs(open1)), max(abs(open2), abs(close0))), max(abs(close1), abs(close2)));
    vec3 turned = max(turn1, turn2);
    nonTranslating = max(max(turned.x, turned.y), turned.z) > 1e-5 * max(max(reach.x, reach.y), reach.z) ? 1u : 0u;
}

SweptBounds shutterBounds() {
#ifdef LIGHT_ORTHOGRAPHIC
    return sweptBoundsOrthographic(open0, open1, open2, close0, close1, close2);
#else
    return sweptBoundsPerspective(open0, open1, open2, close0, close1, close2, lightView.nearDistance);
#endif
}

#ifndef COVER_POINTS
bool projects() {
#ifdef LIGHT_ORTHOGRAPHIC
    return true;
#else
    return min(min(min(open0.z, open1.z), min(open2.z, close0.z)), min(close1.z, close2.z)) > lightView.nearDistance;
#endif
}

// A corner, 0 or 1 in x and y, of the rectangle along the motion, in texels. False where it has not less than 0.8 of
// `area`.
bool turnedCorner(vec2 which, float area, out vec2 corner) {
    vec2 p0 = inTexels(open0), p1 = inTexels(open1), p2 = inTexels(open2);
    vec2 q0 = inTexels(close0), q1 = inTexels(close1), q2 = inTexels(close2);
    vec2 motion = q0 + q1 + q2 - p0 - p1 - p2;
    float way = length(motion);
    vec2 along = way > 1.0 ? motion / way : vec2(1.0, 0.0);
    mat2 turn = transpose(mat2(along, vec2(-along.y, along.x)));  // to along, across
    p0 = turn * p0;
    p1 = turn * p1;
    p2 = turn * p2;
    q0 = turn * q0;
    q1 = turn * q1;
    q2 = turn * q2;
    vec2 low = min(min(min(p0, p1), min(p2, q0)), min(q1, q2)) - SLACK;
    vec2 high = max(max(max(p0, p1), max(p2, q0)), max(q1, q2)) + SLACK;
    corner = mix(low, high, which) * turn;
    vec2 size = high - low;
    return size.x * size.y < 0.8 * area;
}
#endif

void main() {
#ifdef COVER_POINTS
    int index = gl_VertexID;
#else
    int index = gl_VertexID >> 2;
#endif
    outputTriangle(texelFetch(coverTriangles, index).x);
    SweptBounds bounds = shutterBounds();
    vec2 low = clamp(bounds.low * lightView.size - SLACK, vec2(-1.0), lightView.size + 1.0);
    vec2 high = clamp(bounds.high * lightView.size + SLACK, vec2(-1.0), lightView.size + 1.0);
    // A map is sampled at its texels' centres: those outside the bounds cannot be covered.
    vec2 lowPixel = max(ceil(low - 0.5), vec2(0.0)), highPixel = min(floor(high - 0.5) + 1.0, lightView.size);
    gl_PointSize = 1.0;
    gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // outside: clipped
    if (any(greaterThanEqual(lowPixel, highPixel))) return;
#ifdef COVER_POINTS
    float side = max(highPixel.x - lowPixel.x, highPixel.y - lowPixel.y);
    // Kept inside the map, since a point is clipped by its centre.
    vec2 corner = max(min(lowPixel, lightView.size - side), vec2(0.0));
    gl_PointSize = side;
    gl_Position = vec4(2.0 * (corner + 0.5 * side) / lightView.size - 1.0, 0.0, 1.0);
#else
    vec2 which = vec2(gl_VertexID & 1, (gl_VertexID >> 1) & 1);
    vec2 corner = mix(lowPixel, highPixel, which);
    // Far outside the map, positions in texels are too coarse to turn the rectangle.
    if (projects() && all(greaterThan(bounds.low, vec2(-2.0))) && all(lessThan(bounds.high, vec2(3.0)))) {
        vec2 size = high - low, turned;
        if (turnedCorner(which, size.x * size.y, turned)) corner = turned;
    }
    gl_Position = vec4(2.0 * corner / lightView.size - 1.0, 0.0, 1.0);
#endif
}
