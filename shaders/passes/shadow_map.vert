// Depth of the scene as it is at one instant: an ordinary shadow map. The map's plane may be turned, shifted or warped
// by a homography; what is stored is then divided by its weight, which keeps planes plane.
#include "lib/blocks.glsl"

layout(location = 0) in vec3 positionOpen;
layout(location = 1) in vec3 positionClose;
uniform float instant;
uniform mat3 mapFromPlane;

out gl_PerVertex { vec4 gl_Position; };

void main() {
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
