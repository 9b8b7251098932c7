// One point per triangle and stratum: the cheapest cover of a triangle that is small in the image.
#include "lib/stochastic_vertex.glsl"

layout(location = 0) in vec4 texel0;
layout(location = 1) in vec4 texel1;
layout(location = 2) in vec4 texel2;
layout(location = 3) in vec4 texel3;
layout(location = 4) in vec4 texel4;

void main() {
    PixelBounds pixels = coverTriangle(unpackTriangle(texel0, texel1, texel2, texel3, texel4), uint(gl_VertexID));
    ivec2 extent = pixels.high - pixels.low;
    gl_PointSize = 1.0;
    gl_Position = vec4(2.0, 2.0, 0.0, 1.0);  // outside: clipped
    if (extent.x > 0 && extent.y > 0) {
        int side = max(extent.x, extent.y);
        // Kept inside the image, since a point is clipped by its centre.
        vec2 low = vec2(max(min(pixels.low, ivec2(view.size) - side), ivec2(0)));
        vec2 centre = low + 0.5 * float(side);
        gl_PointSize = float(side);
        gl_Position = vec4(2.0 * centre / view.size - 1.0, 0.0, 1.0);
    }
}
