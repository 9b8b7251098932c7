// Images of materials, read at a receiver: with the texture coordinates, wrapping and smaller level that belong there.
//
// MORE_COORDINATES: vertices have texture coordinates 1 and 2.
// VERTEX_COLOURS: vertices have colours.
layout(binding = TRIANGLE_SHADING_UNIT) uniform samplerBuffer triangleShading;
layout(binding = COLOR_IMAGES_UNIT) uniform sampler2DArray colorImages;
layout(binding = DATA_IMAGES_UNIT) uniform sampler2DArray dataImages;
#ifdef MORE_COORDINATES
layout(binding = MORE_COORDINATES_UNIT) uniform samplerBuffer moreCoordinates;
#endif

#if defined(MORE_COORDINATES) || defined(VERTEX_COLOURS)
layout(binding = VERTEX_INDICES_UNIT) uniform usamplerBuffer vertexIndices;

ivec3 verticesOf(uint triangle) {
    int first = 3 * int(triangle);
    return ivec3(texelFetch(vertexIndices, first).x, texelFetch(vertexIndices, first + 1).x,
                 texelFetch(vertexIndices, first + 2).x);
}
#endif

// By how much barycentrics change from a pixel to the next, to the right and upwards.
struct Footprint {
    vec3 right, up;
};

Footprint footprintOf(MovingTriangle t, Receiver r) {
    vec2 pixel = 1.0 / cameraView.size;
    vec3 here = edgesOnRay(t, r.place, r.time);
    vec3 right = edgesOnRay(t, r.place + vec2(pixel.x, 0.0), r.time) - here;
    vec3 up = edgesOnRay(t, r.place + vec2(0.0, pixel.y), r.time) - here;
    float sum = here.x + here.y + here.z;
    Footprint f;
    f.right = (right - r.barycentrics * (right.x + right.y + right.z)) / sum;
    f.up = (up - r.barycentrics * (up.x + up.y + up.z)) / sum;
    return f;
}

// Texture coordinates of a triangle's corners.
struct Corners {
    vec2 a, b, c;
};

Corners cornersOf(uint triangle, uint coordinates) {
#ifdef MORE_COORDINATES
    if (coordinates > 0u) {
        ivec3 v = verticesOf(triangle);
        vec4 a = texelFetch(moreCoordinates, v.x), b = texelFetch(moreCoordinates, v.y),
             c = texelFetch(moreCoordinates, v.z);
        return coordinates == 1u ? Corners(a.xy, b.xy, c.xy) : Corners(a.zw, b.zw, c.zw);
    }
#endif
    int first = int(triangle) * TRIANGLE_SHADING_TEXELS;
    vec4 e = texelFetch(triangleShading, first + 4), f = texelFetch(triangleShading, first + 5);
    return Corners(e.zw, f.xy, f.zw);
}

vec2 weighted(vec3 weights, Corners c) { return weights.x * c.a + weights.y * c.b + weights.z * c.c; }

// A coordinate brought to where the image, which repeats, has what the wrapping asks for. margin: half a texel, within
// which filtering would take the other side's.
float wrapped(float x, uint wrap, float margin) {
    if (wrap == TEXTURE_REPEATS) return x;
    if (wrap == TEXTURE_MIRRORS) x = abs(x - 2.0 * floor(0.5 * x + 0.5));
    return clamp(x, margin, 1.0 - margin);
}

// The mean over half a pixel, on its longer side: the samples of a pixel see to the rest, and a picture does not get
// blurred further than they do.
vec4 readImage(sampler2DArray images, float layer, uint use, Receiver r, Footprint footprint) {
    Corners c = cornersOf(r.triangle, use & TEXTURE_COORDINATES);
    vec2 uv = weighted(r.barycentrics, c);
    float side = float(textureSize(images, 0).x);
    vec2 right = weighted(footprint.right, c) * side, up = weighted(footprint.up, c) * side;
    float smallest = float(textureQueryLevels(images) - 1);
    float level = clamp(0.5 * log2(0.25 * max(dot(right, right), dot(up, up))), 0.0, smallest);
    float margin = 0.5 / float(textureSize(images, int(ceil(level))).x);
    uv.x = wrapped(uv.x, (use >> TEXTURE_WRAP_U_SHIFT) & TEXTURE_WRAP, margin);
    uv.y = wrapped(uv.y, (use >> TEXTURE_WRAP_V_SHIFT) & TEXTURE_WRAP, margin);
    return textureLod(images, vec3(uv, layer), level);
}
