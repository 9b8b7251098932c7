// How a receiver finds its place and depth in the light's map.
#include "lib/receiver.glsl"
#include "lib/texel_width.glsl"

struct MapPoint {
    vec2 position;  // in [0, 1] inside the map
    float depth;    // distance from the light's plane along its axis, world units
    vec2 slope;     // change of the receiver plane's depth over a whole map in x and y
    float texel;    // width of a texel at this depth, world units
};

// r must be at time `u`: the map's centre of projection is where the light is then.
MapPoint mapPointOf(Receiver r, float u) {
    vec3 v = mix((lightView.viewFromWorldOpen * vec4(r.position, 1.0)).xyz, (lightView.viewFromWorldClose * vec4(r.position, 1.0)).xyz, u);
    mat3 axes = mat3(lightView.viewFromWorldOpen);
    vec3 plane = cross(axes * r.edge1, axes * r.edge2);
    MapPoint m;
    m.depth = v.z;
    m.texel = texelWidth(v.z);
#ifdef LIGHT_ORTHOGRAPHIC
    m.position = v.xy;
    // plane . v = const, so depth changes by -plane.xy / plane.z.
    float along = plane.z;
    m.slope = -plane.xy / (abs(along) > 1e-20 ? along : 1e-20);
#else
    m.position = v.xy / v.z;
    // depth = const / (plane . (s, t, 1)).
    float along = dot(plane, vec3(m.position, 1.0));
    m.slope = -plane.xy * (v.z / (abs(along) > 1e-20 ? along : 1e-20));
#endif
    return m;
}

// How fast the depth of the receiver's plane changes at a fixed place of the map.
float mapDepthRate(MapPoint m, MovingTriangle t, float u) {
    vec3 a0 = (lightView.viewFromWorldOpen * vec4(t.open0, 1.0)).xyz, d0 = (lightView.viewFromWorldClose * vec4(t.close0, 1.0)).xyz - a0;
    vec3 a1 = (lightView.viewFromWorldOpen * vec4(t.open1, 1.0)).xyz, d1 = (lightView.viewFromWorldClose * vec4(t.close1, 1.0)).xyz - a1;
    vec3 a2 = (lightView.viewFromWorldOpen * vec4(t.open2, 1.0)).xyz, d2 = (lightView.viewFromWorldClose * vec4(t.close2, 1.0)).xyz - a2;
    vec3 v0 = a0 + u * d0, v1 = a1 + u * d1, v2 = a2 + u * d2;
    vec2 p = m.position;
#ifdef LIGHT_ORTHOGRAPHIC
    return depthRateAtPlace(v0.xy - p, v1.xy - p, v2.xy - p, d0.xy, d1.xy, d2.xy, vec3(v0.z, v1.z, v2.z), vec3(d0.z, d1.z, d2.z));
#else
    return depthRateAtPlace(v0.xy - p * v0.z, v1.xy - p * v1.z, v2.xy - p * v2.z, d0.xy - p * d0.z, d1.xy - p * d1.z, d2.xy - p * d2.z,
                            vec3(v0.z, v1.z, v2.z), vec3(d0.z, d1.z, d2.z));
#endif
}

// What has to be allowed for before a depth of the map counts as nearer: `bias` texels, and `slopeBias` times the most
// that the receiver's own plane rises within half a texel of the receiver. Grazing planes are held at 16 texels.
float depthBias(MapPoint m, float bias, float slopeBias) {
    float rise = 0.5 * (abs(m.slope.x) + abs(m.slope.y)) / lightView.size.x;
    return bias * m.texel + slopeBias * min(rise, 16.0 * m.texel);
}

// Distance that a stored (reversed) depth stands for; far beyond everything where nothing was drawn.
float mapDistance(float stored) {
#ifdef LIGHT_ORTHOGRAPHIC
    return stored > 0.0 ? (1.0 - stored) * lightView.farDistance : 1e30;
#else
    return stored > 0.0 ? lightView.nearDistance / stored : 1e30;
#endif
}
