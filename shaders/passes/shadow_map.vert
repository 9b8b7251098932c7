// Depth of the scene as it is at one instant: an ordinary shadow map. The map's plane may be turned, shifted or warped
// by a homography; what is stored is then divided by its weight, which keeps planes plane.
//
// CUTOUTS: three vertices a triangle, which know their triangle and their corner, instead of those that triangles
// share.
#include "lib/blocks.glsl"
#ifdef CUTOUTS
#include "lib/triangle_texels.glsl"
layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
flat out uint casterTriangle;
out vec3 casterWeights;
#else
layout(location = 0) in vec3 positionOpen;
layout(location = 1) in vec3 positionClose;
#endif
uniform float instant;
uniform mat3 mapFromPlane;

out gl_PerVertex { vec4 gl_Position; };

void main() {
#ifdef CUTOUTS
    casterTriangle = uint(gl_VertexID) / 3u;
    uint corner = uint(gl_VertexID) % 3u;
    casterWeights = vec3(corner == 0u, corner == 1u, corner == 2u);
    VertexMotion t = fetchMotion(trianglePositions, casterTriangle, true);
    vec3 positionOpen = corner == 0u ? t.open0 : corner == 1u ? t.open1 : t.open2;
    vec3 positionClose = corner == 0u ? t.close0 : corner == 1u ? t.close1 : t.close2;
#endif
    vec3 v = mix((lightView.viewFromWorldOpen * vec4(positionOpen, 1.0)).xyz,
                 (lightView.viewFromWorldClose * vec4(positionClose, 1.0)).xyz, instant);
#ifdef LIGHT_ORTHOGRAPHIC
    // Where a sun turns over a vertex that moves, its path is a parabola, of which the line above knows the ends.
    mat3 turn = mat3(lightView.viewFromWorldClose) - mat3(lightView.viewFromWorldOpen);
    v -= instant * (1.0 - instant) * (turn * (positionClose - positionOpen));
    vec3 h = mapFromPlane * vec3(v.xy, 1.0);
    gl_Position = vec4(2.0 * h.xy - h.z, 1.0 - v.z / lightView.farDistance, h.z);
#else
    // Reversed and without a far plane: depth = near / distance.
    vec3 h = mapFromPlane * v;
    gl_Position = vec4(2.0 * h.xy - h.z, lightView.nearDistance, h.z);
#endif
}
