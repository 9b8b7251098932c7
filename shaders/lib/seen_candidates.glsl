// The triangles that move before the camera, in view coordinates, and per tile of the picture those that may be seen in
// it during the shutter.
#include "lib/blocks.glsl"
#include "lib/triangle_texels.glsl"
#include "shared/seen_interval.shared.h"
#include "shared/time_union.shared.h"

uniform samplerBuffer seenTriangles;     // TRIANGLE_POSITION_TEXELS a triangle
uniform usamplerBuffer seenTriangleIds;  // which triangle of the mesh each is
uniform usamplerBuffer tileOffsets;      // where each tile's lists begin, one a bucket of time; one more at the end
uniform usamplerBuffer tileCandidates;   // x: number of a seen triangle, y: where in the tile it may be seen
uniform int tilesInRow;
uniform uint tileSide;  // pixels
uniform uint buckets;

struct SeenTriangle {
    ViewPath path;
    bool doubleSided;
};

SeenTriangle seenTriangle(uint number) {
    MovingTriangle t = fetchTriangleFrom(seenTriangles, number);
    return SeenTriangle(ViewPath(t.open0, t.open1, t.open2, t.close0, t.close1, t.close2), t.doubleSided);
}

int firstListOf(uvec2 pixel) {
    return (int(pixel.y / tileSide) * tilesInRow + int(pixel.x / tileSide)) * int(buckets);
}

ivec2 tileSpan(uvec2 pixel, uint bucket) {
    int list = firstListOf(pixel) + int(bucket);
    return ivec2(texelFetch(tileOffsets, list).x, texelFetch(tileOffsets, list + 1).x);
}

uint bucketOf(float tick) {
    uint bucket = min(uint(tick / TICKS * float(buckets)), buckets - 1u);
    float end = floor(float(bucket + 1u) / float(buckets) * TICKS + 0.5);
    return tick < end ? bucket : bucket + 1u;
}

bool anyCandidates(uvec2 pixel) {
    int list = firstListOf(pixel);
    return texelFetch(tileOffsets, list).x < texelFetch(tileOffsets, list + int(buckets)).x;
}

// Bounds of a candidate, in 255ths of the tile, rounded outwards: low x, low y, high x, high y from the lowest byte on.
bool isWithin(uint bounds, vec2 inTile) {
    uvec4 b = (uvec4(bounds) >> uvec4(0u, 8u, 16u, 24u)) & 255u;
    vec2 at = inTile * 255.0;
    return all(lessThanEqual(vec2(b.xy), at)) && all(lessThanEqual(at, vec2(b.zw)));
}
