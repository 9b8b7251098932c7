// The shadow map test of a surface point and how sure it is.
#include "techniques/history/blocks.glsl"

layout(binding = SHADOW_MAP_UNIT) uniform sampler2DArray shadowMap;

struct ShadowTest {
    float lit;         // 0, 1, or the mean over the texels of the filter
    float confidence;  // equation 5; 0 outside the map
};

// The receiver's place in this frame's map, which is turned and shifted (or warped) against the light's map plane.
struct WarpedPoint {
    vec2 texel;  // position in texels
    MapPoint m;  // with slope and texel as the warped map has them
    MapPoint plane;
};

WarpedPoint warpedPointOf(Receiver r, float u) {
    WarpedPoint p;
    p.plane = mapPointOf(r, u);
    mat3 warp = mat3(history.mapFromPlane);
    vec3 h = warp * vec3(p.plane.position, 1.0);
    p.m = p.plane;
    p.m.position = h.xy / h.z;
    p.texel = p.m.position * lightView.size;
    // Rows of the change of the warped position with the plane's position.
    vec3 weightRow = vec3(warp[0].z, warp[1].z, warp[2].z);
    vec2 rowX = (vec2(warp[0].x, warp[1].x) - p.m.position.x * weightRow.xy) / h.z;
    vec2 rowY = (vec2(warp[0].y, warp[1].y) - p.m.position.y * weightRow.xy) / h.z;
    float area = rowX.x * rowY.y - rowX.y * rowY.x;
    p.m.slope = vec2(rowY.y * p.plane.slope.x - rowY.x * p.plane.slope.y, rowX.x * p.plane.slope.y - rowX.y * p.plane.slope.x) / area;
    p.m.texel = p.plane.texel * inversesqrt(abs(area));
    return p;
}

// Depth of the receiver's own plane where the ray through a texel's centre meets it. A grazing plane is held within 32
// texels of the receiver.
float planeDepthAt(WarpedPoint p, vec2 position) {
    float rise = dot(p.plane.slope, position - p.plane.position);
#ifndef LIGHT_ORTHOGRAPHIC
    rise /= max(1.0 - rise / p.plane.depth, 1e-3);
#endif
    return p.plane.depth + clamp(rise, -32.0 * p.m.texel, 32.0 * p.m.texel);
}

float litByTexel(WarpedPoint p, ivec2 texel, float publishedDepth) {
    if (any(lessThan(texel, ivec2(0))) || any(greaterThanEqual(texel, ivec2(lightView.size)))) return 1.0;
    vec3 q = mat3(history.planeFromMap) * vec3((vec2(texel) + 0.5) / lightView.size, 1.0);
    // What is stored has been divided by the warp's weight there, 1 / q.z.
    float caster = mapDistance(texelFetch(shadowMap, ivec3(texel, 0), 0).x / q.z);
    float depth = history.asPublished != 0u ? publishedDepth : planeDepthAt(p, q.xy / q.z) - history.bias * p.m.texel;
    return depth > caster ? 0.0 : 1.0;
}

ShadowTest testShadow(Receiver r, float u) {
    WarpedPoint p = warpedPointOf(r, u);
    ivec2 texel = ivec2(floor(p.texel));
    int radius = int(history.pcfRadius);
    float publishedDepth = p.m.depth - depthBias(p.m, history.bias, history.slopeBias * float(2 * radius + 1));
    ShadowTest test;
    test.lit = 0.0;
    for (int y = -radius; y <= radius; ++y)
        for (int x = -radius; x <= radius; ++x) test.lit += litByTexel(p, texel + ivec2(x, y), publishedDepth);
    test.lit /= float((2 * radius + 1) * (2 * radius + 1));
    bool inside = all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(lightView.size)));
    test.confidence = inside ? shadowTestConfidence(p.texel) : 0.0;
    return test;
}
