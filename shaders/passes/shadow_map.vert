// Depth of the scene as it is at one instant: an ordinary shadow map.
#include "lib/blocks.glsl"

layout(location = 0) in vec3 positionOpen;
layout(location = 1) in vec3 positionClose;
layout(location = 0) uniform float instant;

out gl_PerVertex { vec4 gl_Position; };

void main() {
    vec3 v = mix((lightView.viewFromWorldOpen * vec4(positionOpen, 1.0)).xyz,
                 (lightView.viewFromWorldClose * vec4(positionClose, 1.0)).xyz, instant);
#ifdef LIGHT_ORTHOGRAPHIC
    gl_Position = vec4(2.0 * v.xy - 1.0, 1.0 - v.z / lightView.farDistance, 1.0);
#else
    // Reversed and without a far plane: depth = near / distance.
    gl_Position = vec4(2.0 * v.xy - v.z, lightView.nearDistance, v.z);
#endif
}
