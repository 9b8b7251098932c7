// Covers whatever texels a moving triangle may visit during the shutter, cheaply; the fragments decide.
// COVER_POINTS: one point a triangle, for small sweeps. Else a rectangle of four indexed vertices, along the motion where that is
// smaller: a triangle that flies far sweeps a narrow band of its bounding box.
#include "lib/blocks.glsl"
#include "shared/swept_bounds.shared.h"
#include "techniques/temporal/bindings.shared.h"

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

vec2 texelOf(vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return v.xy * lightView.size;
#else
    return v.xy / v.z * lightView.size;
#endif
}

void main() {
#ifdef COVER_POINTS
    int index = gl_VertexID;
#else
    int index = gl_VertexID >> 2;
#endif
    triangleId = texelFetch(coverTriangles, index).x;
    int first = int(triangleId) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(trianglePositions, first), b = texelFetch(trianglePositions, first + 1),
         c = texelFetch(trianglePositions, first + 2), d = texelFetch(trianglePositions, first + 3),
         e = texelFetch(trianglePositions, first + 4);
    open0 = (lightView.viewFromWorldOpen * vec4(a.xyz, 1.0)).xyz;
    open1 = (lightView.viewFromWorldOpen * vec4(a.w, b.xy, 1.0)).xyz;
    open2 = (lightView.viewFromWorldOpen * vec4(b.zw, c.x, 1.0)).xyz;
    close0 = (lightView.viewFromWorldClose * vec4(c.yzw, 1.0)).xyz;
    close1 = (lightView.viewFromWorldClose * vec4(d.xyz, 1.0)).xyz;
    close2 = (lightView.viewFromWorldClose * vec4(d.w, e.xy, 1.0)).xyz;

    vec3 motion0 = close0 - open0, turn1 = abs(close1 - open1 - motion0), turn2 = abs(close2 - open2 - motion0);
    vec3 reach = max(max(max(abs(open0), abs(open1)), max(abs(open2), abs(close0))), max(abs(close1), abs(close2)));
    vec3 turned = max(turn1, turn2);
    nonTranslating = max(max(turned.x, turned.y), turned.z) > 1e-5 * max(max(reach.x, reach.y), reach.z) ? 1u : 0u;

#ifdef LIGHT_ORTHOGRAPHIC
    SweptBounds bounds = sweptBoundsOrthographic(open0, open1, open2, close0, close1, close2);
    bool projects = true;
#else
    SweptBounds bounds = sweptBoundsPerspective(open0, open1, open2, close0, close1, close2, lightView.nearDistance);
    bool projects = min(min(min(open0.z, open1.z), min(open2.z, close0.z)), min(close1.z, close2.z)) > lightView.nearDistance;
#endif
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
    vec2 place = mix(lowPixel, highPixel, which);
    // Far outside the map, positions in texels are too coarse to turn the rectangle.
    if (projects && all(greaterThan(bounds.low, vec2(-2.0))) && all(lessThan(bounds.high, vec2(3.0)))) {
        vec2 p0 = texelOf(open0), p1 = texelOf(open1), p2 = texelOf(open2), q0 = texelOf(close0), q1 = texelOf(close1), q2 = texelOf(close2);
        vec2 motion = q0 + q1 + q2 - p0 - p1 - p2;
        float way = length(motion);
        vec2 along = way > 1.0 ? motion / way : vec2(1.0, 0.0);
        mat2 turn = transpose(mat2(along, vec2(-along.y, along.x)));  // to along, across
        p0 = turn * p0; p1 = turn * p1; p2 = turn * p2; q0 = turn * q0; q1 = turn * q1; q2 = turn * q2;
        vec2 lowTurned = min(min(min(p0, p1), min(p2, q0)), min(q1, q2)) - SLACK;
        vec2 highTurned = max(max(max(p0, p1), max(p2, q0)), max(q1, q2)) + SLACK;
        vec2 size = high - low, sizeTurned = highTurned - lowTurned;
        if (sizeTurned.x * sizeTurned.y < 0.8 * size.x * size.y) place = mix(lowTurned, highTurned, which) * turn;
    }
    gl_Position = vec4(2.0 * place / lightView.size - 1.0, 0.0, 1.0);
#endif
}
