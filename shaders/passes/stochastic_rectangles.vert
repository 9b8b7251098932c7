// One rectangle per triangle and stratum, drawn as a strip of four vertices an instance: for triangles that are large
// in the image, or cross the near plane.
#include "lib/stochastic_vertex.glsl"

layout(binding = TRIANGLE_POSITIONS_UNIT) uniform samplerBuffer trianglePositions;
layout(binding = LARGE_TRIANGLES_UNIT) uniform usamplerBuffer largeTriangles;

void main() {
    uint id = texelFetch(largeTriangles, gl_InstanceID).x;
    PixelBounds pixels = coverTriangle(fetchTriangleFrom(trianglePositions, id), id);
    gl_PointSize = 1.0;
    gl_Position = vec4(2.0, 2.0, 0.0, 1.0);
    if (all(lessThan(pixels.low, pixels.high))) {
        vec2 corner = vec2((gl_VertexID & 1) == 0 ? pixels.low.x : pixels.high.x,
                           (gl_VertexID & 2) == 0 ? pixels.low.y : pixels.high.y);
        gl_Position = vec4(2.0 * corner / view.size - 1.0, 0.0, 1.0);
    }
}
