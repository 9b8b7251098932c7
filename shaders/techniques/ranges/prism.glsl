// The prism of a moving triangle: its swept volume as a closed surface of 14 triangles (Hong and Oh 2019, section 4.1).
#include "lib/blocks.glsl"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
uniform usamplerBuffer prismTriangles;  // numbers of the triangles that have a prism

// View coordinates of the light, linear in u.
struct Prism { vec3 open[3]; vec3 close[3]; };

vec3 viewOpen(vec3 position) { return (lightView.viewFromWorldOpen * vec4(position, 1.0)).xyz; }
vec3 viewClose(vec3 position) { return (lightView.viewFromWorldClose * vec4(position, 1.0)).xyz; }

Prism prismOf(uint id) {
    int first = int(id) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(trianglePositions, first), b = texelFetch(trianglePositions, first + 1),
         c = texelFetch(trianglePositions, first + 2), d = texelFetch(trianglePositions, first + 3),
         e = texelFetch(trianglePositions, first + 4);
    Prism p;
    p.open[0] = viewOpen(a.xyz);
    p.open[1] = viewOpen(vec3(a.w, b.xy));
    p.open[2] = viewOpen(vec3(b.zw, c.x));
    p.close[0] = viewClose(c.yzw);
    p.close[1] = viewClose(d.xyz);
    p.close[2] = viewClose(vec3(d.w, e.xy));
    return p;
}

vec4 clipPosition(vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return vec4(2.0 * v.xy - 1.0, 1.0 - v.z / lightView.farDistance, 1.0);
#else
    return vec4(2.0 * v.xy - v.z, lightView.nearDistance, v.z);  // reversed and without a far plane
#endif
}
