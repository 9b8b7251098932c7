// The nine vertices of each prism: 0..2 the triangle at u = 0, 3..5 at u = 1, 6..8 the centres of its three sides. The
// index buffer makes 14 triangles of them, each with its part in the vertex that it ends with: so no vertex is computed
// twice, and neighbouring triangles share theirs to the last bit, which keeps the surface closed.
#include "techniques/ranges/prism.glsl"
#include "techniques/ranges/prism_parts.glsl"

out gl_PerVertex { vec4 gl_Position; };
out float prismTime;
out vec3 prismCorners;  // how near to each corner of the triangle: along side i the i-th falls from 1 to 0
#ifdef LIGHT_ORTHOGRAPHIC
out float prismDistance;
#endif
flat out uint prismId;
flat out uint prismPart;
flat out uint prismMoves;  // 0: the triangle is static after all
flat out vec3 prismTwist;  // of a side (shared/prism_side.shared.h)

void main() {
    int corner = gl_VertexID % 9;
    prismId = texelFetch(prismTriangles, gl_VertexID / 9).x;
    Prism p = prismOf(prismId);
    prismMoves = p.open[0] != p.close[0] || p.open[1] != p.close[1] || p.open[2] != p.close[2] ? 1u : 0u;
    vec3 v;
    prismTwist = vec3(0.0);
    prismCorners = vec3(0.0);
    if (corner < 6) prismCorners[corner % 3] = 1.0;
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
        prismTwist = (p.open[i] - p.open[j]) - (p.close[i] - p.close[j]);
        prismPart = PART_SIDE + uint(i);
        prismCorners[i] = 0.5;
        prismCorners[j] = 0.5;
    }
#ifdef LIGHT_ORTHOGRAPHIC
    prismDistance = v.z;
#endif
    gl_Position = clipPosition(v);
}
