// One vertex per prism: which triangle it belongs to. The geometry shader does the rest.
#include "techniques/ranges/prism.glsl"

flat out uint triangleOfPoint;

void main() { triangleOfPoint = texelFetch(prismTriangles, gl_VertexID).x; }
