// A shadow map that is turned, shifted or warped against the light's image plane by a homography (passes/map_fit.h):
// where a receiver lies in it, and the depth of the receiver's own plane at a texel of it.
#include "lib/light_map.glsl"

// The receiver's position in such a map.
struct WarpedPoint {
    vec2 texel;  // position in texels
    MapPoint m;  // with slope and texel as the warped map has them
    MapPoint plane;
};

WarpedPoint warpedPointOf(Receiver r, float u, mat3 warp) {
    WarpedPoint p;
    p.plane = mapPointOf(r, u);
    vec3 h = warp * vec3(p.plane.position, 1.0);
    p.m = p.plane;
    p.m.position = h.xy / h.z;
    p.texel = p.m.position * lightView.size;
    // Rows of the change of the warped position with the plane's position.
    vec3 weightRow = vec3(warp[0].z, warp[1].z, warp[2].z);
    vec2 rowX = (vec2(warp[0].x, warp[1].x) - p.m.position.x * weightRow.xy) / h.z;
    vec2 rowY = (vec2(warp[0].y, warp[1].y) - p.m.position.y * weightRow.xy) / h.z;
    float area = rowX.x * rowY.y - rowX.y * rowY.x;
    p.m.slope =
        vec2(rowY.y * p.plane.slope.x - rowY.x * p.plane.slope.y, rowX.x * p.plane.slope.y - rowX.y * p.plane.slope.x) /
        area;
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

// At a texel's centre; what the map stores there has been divided by the warp's weight, 1 / inverseWeight.
float planeDepthAtTexel(WarpedPoint p, mat3 planeFromMap, ivec2 texel, out float inverseWeight) {
    vec3 q = planeFromMap * vec3((vec2(texel) + 0.5) / lightView.size, 1.0);
    inverseWeight = q.z;
    return planeDepthAt(p, q.xy / q.z);
}
