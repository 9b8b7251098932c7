// The prism of a moving triangle: its swept volume as a closed surface of 14 triangles (Hong and Oh 2019, section 4.1).
#include "lib/light_projection.glsl"
#include "lib/triangle_texels.glsl"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
uniform usamplerBuffer prismTriangles;  // numbers of the triangles that have a prism

// View coordinates of the light, linear in u.
struct Prism {
    vec3 open[3], close[3];
};

Prism prismOf(uint id) {
    VertexMotion v =
        inView(fetchMotion(trianglePositions, id, true), lightView.viewFromWorldOpen, lightView.viewFromWorldClose);
    return Prism(vec3[3](v.open0, v.open1, v.open2), vec3[3](v.close0, v.close1, v.close2));
}

vec4 clipPosition(vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return vec4(2.0 * v.xy - 1.0, ndcDepth(v.z), 1.0);
#else
    return vec4(2.0 * v.xy - v.z, lightView.nearDistance, v.z);  // reversed and without a far plane
#endif
}
