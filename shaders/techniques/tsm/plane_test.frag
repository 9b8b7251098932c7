// Time-dependent shadow maps, the receiver's plane tested where and when the texel looks: what the map holds there is
// compared with the depth of the plane of the receiver's triangle, seen through the texel's centre at the texel's time
// (ours). A plane surface is never nearer to the light than itself, whatever moves, so that one bias serves for all.
// Static casters are compared at the receiver's time.
//
// PCF_RADIUS: as in lib/pcf.glsl. DYNAMIC_CASTERS: there are such.
#include "lib/lookup.glsl"
#include "lib/pcf.glsl"
#include "lib/receiver_plane.glsl"
#include "techniques/tsm/layers.glsl"

// Of the plane at one time, less the bias.
float limitAt(PathInView path, float u, ivec2 texel) {
    float depth = planeDepth(planeInView(path, u), (vec2(texel) + 0.5) / lightView.size);
    return depth - setting.bias * texelWidth(depth);
}

bool shadowedInTexel(MapPoint m, PathInView path, float u) {
    ivec2 texel;
    if (!texelOf(m, texel)) return false;
    if (limitAt(path, u, texel) > mapDistance(texelFetch(staticMap, ivec3(texel, 0), 0).x)) return true;
#if defined(DYNAMIC_CASTERS) && !defined(STATIC_CASTERS_ONLY)
    uint layer = layerAt(u, stratum);
    float xi = samplePattern(uvec2(texel), frame.firstStratum + layer, frame.seed, SALT_LIGHT).z;
    float castersTime = sampleTime(frame.timeBase, layerLength, layer, xi);
    if (limitAt(path, castersTime, texel) > mapDistance(texelFetch(depthMap, ivec3(texel, layer), 0).x)) return true;
#endif
    return false;
}

float litOf(MovingTriangle t, Receiver r) {
    MapPoint m = mapPointOf(r, r.time);
    PathInView path = pathInView(t, r.barycentrics);
    float lit = 0.0;
    for (int i = 0; i < pcfTests; ++i)
        lit += shadowedInTexel(movedByTexels(m, pcfOffset(i)), path, r.time) ? 0.0 : 1.0;
    return lit / float(pcfTests);
}

#include "lib/lookup_main.glsl"
