// How a receiver finds its position and depth in the shadow map.
#include "lib/light_projection.glsl"
#include "lib/receiver.glsl"

struct MapPoint {
    vec2 position;  // in [0, 1] inside the map
    float depth;    // distance from the light's plane along its axis, world units
    vec2 slope;     // change of the receiver plane's depth over a whole map in x and y
    float texel;    // width of a texel at this depth, world units
};

// r must be at time `u`: the map's centre of projection is where the light is then.
MapPoint mapPointOf(Receiver r, float u) {
    vec3 v = mix(transformed(lightView.viewFromWorldOpen, r.position),
                 transformed(lightView.viewFromWorldClose, r.position), u);
    mat3 open = mat3(lightView.viewFromWorldOpen);
    mat3 axes = open + (mat3(lightView.viewFromWorldClose) - open) * u;  // a sun's turn
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

bool insideMap(ivec2 texel) {
    return all(greaterThanEqual(texel, ivec2(0))) && all(lessThan(texel, ivec2(lightView.size)));
}

// The texel that the point lies in; false outside the map.
bool texelOf(MapPoint m, out ivec2 texel) {
    texel = ivec2(floor(m.position * lightView.size));
    return insideMap(texel);
}

// How fast the depth of the receiver's plane changes at a fixed position of the map.
float mapDepthRate(MapPoint m, MovingTriangle t, float u) {
    VertexMotion world = VertexMotion(t.open0, t.open1, t.open2, t.close0, t.close1, t.close2);
    VertexMotion v = inView(world, lightView.viewFromWorldOpen, lightView.viewFromWorldClose);
    vec3 d0 = v.close0 - v.open0, d1 = v.close1 - v.open1, d2 = v.close2 - v.open2;
    vec3 v0 = v.open0 + u * d0, v1 = v.open1 + u * d1, v2 = v.open2 + u * d2;
    vec2 p = m.position;
    return depthRateAtPlace(seenFrom(p, v0), seenFrom(p, v1), seenFrom(p, v2), seenRate(p, d0), seenRate(p, d1),
                            seenRate(p, d2), vec3(v0.z, v1.z, v2.z), vec3(d0.z, d1.z, d2.z));
}

// What has to be allowed for before a depth of the map counts as nearer: `bias` texels, and `slopeBias` times the most
// that the receiver's own plane rises within half a texel of the receiver. Grazing planes are held at 16 texels.
float depthBias(MapPoint m, float bias, float slopeBias) {
    vec2 slope = abs(m.slope) / lightView.size;
    float rise = 0.5 * (slope.x + slope.y);
    return bias * m.texel + slopeBias * min(rise, 16.0 * m.texel);
}
