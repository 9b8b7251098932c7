// The nine vertices of each prism: 0..2 the triangle at u = 0, 3..5 at u = 1, 6..8 the centres of its three sides. The index
// buffer makes 14 triangles of them, each with its kind in the vertex that it ends with: so no vertex is computed twice,
// and neighbouring triangles share theirs to the last bit, which keeps the surface closed.
#include "techniques/ranges/prism.glsl"
#include "techniques/ranges/prism_parts.glsl"

out gl_PerVertex { vec4 gl_Position; };
out float prismTime;
#ifdef LIGHT_ORTHOGRAPHIC
out float prismDistance;
#endif
flat out uint prismId;
flat out uint prismPart;

void main() {
    int corner = gl_VertexID % 9;
    prismId = texelFetch(prismTriangles, gl_VertexID / 9).x;
    Prism p = prismOf(prismId);
    vec3 v;
    if (corner < 3) {
        v = p.open[corner];
        prismTime = 0.0;
        prismPart = PART_OPEN;
    } else if (corner < 6) {
        v = p.close[corner - 3];
        prismTime = 1.0;
        prismPart = PART_CLOSE;
    } else {
        int i = corner - 6, j = i < 2 ? i + 1 : 0;
        v = 0.25 * ((p.open[i] + p.open[j]) + (p.close[i] + p.close[j]));
        prismTime = 0.5;
        prismPart = PART_SIDE;
    }
#ifdef LIGHT_ORTHOGRAPHIC
    prismDistance = v.z;
#endif
    gl_Position = clipPosition(v);
}
