// A receiver that is followed as a point of its triangle over the shutter, in the light's view, and the depth of its
// triangle's plane anywhere in the map. Linear in u between the ends of the shutter, as the triangles of a map over
// time are.
#include "lib/light_map.glsl"

struct PathInView {
    vec3 open, close;  // view coordinates at u = 0 and u = 1
    vec3 edge1Open, edge1Close, edge2Open, edge2Close;
};

// A receiver at one time, in the light's view.
struct PlaneInView {
    vec2 position;  // in the map
    float depth;    // distance along the light's axis, world units
    vec3 normal;    // not normalised; of an unknown side
    float towards;  // of the normal along the line from the light: 0 edge-on, another sign seen from behind
};

PathInView pathInView(MovingTriangle t, vec3 barycentrics) {
    VertexMotion world = VertexMotion(t.open0, t.open1, t.open2, t.close0, t.close1, t.close2);
    VertexMotion v = inView(world, lightView.viewFromWorldOpen, lightView.viewFromWorldClose);
    vec3 b = barycentrics;
    return PathInView(b.x * v.open0 + b.y * v.open1 + b.z * v.open2, b.x * v.close0 + b.y * v.close1 + b.z * v.close2,
                      v.open1 - v.open0, v.close1 - v.close0, v.open2 - v.open0, v.close2 - v.close0);
}

// Of the triangle at time u, moved to where `v` lies in it.
PlaneInView planeThrough(PathInView path, vec3 v, float u) {
    PlaneInView p;
    p.depth = v.z;
    p.normal = cross(mix(path.edge1Open, path.edge1Close, u), mix(path.edge2Open, path.edge2Close, u));
#ifdef LIGHT_ORTHOGRAPHIC
    p.position = v.xy;
    p.towards = p.normal.z;
#else
    p.position = v.xy / v.z;
    p.towards = dot(p.normal, vec3(p.position, 1.0));
#endif
    return p;
}

PlaneInView planeInView(PathInView path, float u) { return planeThrough(path, mix(path.open, path.close, u), u); }

// Where the line from the light through a map position meets the plane. One that falls away from the light by more than
// 32 texels within one is held there, as depthBias holds it: it may not be met at all. What is nearer is not held: what
// the map has of the triangle itself is never nearer than this.
float planeDepth(PlaneInView p, vec2 position) {
    vec2 off = position - p.position;
    float most = 32.0 * texelWidth(p.depth) * dot(abs(off) * lightView.size, vec2(1.0));
    float rise = -dot(p.normal.xy, off);
#ifdef LIGHT_ORTHOGRAPHIC
    bool isMet = abs(p.towards) * most > abs(rise);
    rise /= p.towards;
#else
    float along = p.towards - rise;
    bool isMet = along * p.towards > 0.0;
    rise *= p.depth / along;
#endif
    return p.depth + (isMet ? min(rise, most) : most);
}
