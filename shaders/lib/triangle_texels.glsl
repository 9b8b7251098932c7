// How a moving triangle lies in the buffer textures of positions and of shading (renderer/plan/mesh_texels.h): three
// vectors at u = 0 and three at u = 1, packed without holes into the first 18 floats.
#include "shared/frame_blocks.shared.h"

// One vector per vertex (a position or a normal) at either end of the shutter; in between each is linear in u.
struct VertexMotion {
    vec3 open0, open1, open2;     // at u = 0
    vec3 close0, close1, close2;  // at u = 1
};

struct MovingTriangle {
    vec3 open0, open1, open2;     // world space less the origin, at u = 0
    vec3 close0, close1, close2;  // at u = 1
    bool doubleSided;
    uint material;
};

VertexMotion unpackStatic(vec4 a, vec4 b, vec4 c) {
    vec3 v0 = a.xyz, v1 = vec3(a.w, b.xy), v2 = vec3(b.zw, c.x);
    return VertexMotion(v0, v1, v2, v0, v1, v2);
}

VertexMotion unpackMotion(vec4 a, vec4 b, vec4 c, vec4 d, vec4 e) {
    VertexMotion v = unpackStatic(a, b, c);
    v.close0 = c.yzw;
    v.close1 = d.xyz;
    v.close2 = vec3(d.w, e.xy);
    return v;
}

MovingTriangle unpackTriangle(vec4 a, vec4 b, vec4 c, vec4 d, vec4 e) {
    VertexMotion v = unpackMotion(a, b, c, d, e);
    return MovingTriangle(v.open0, v.open1, v.open2, v.close0, v.close1, v.close2, e.z != 0.0, uint(e.w));
}

MovingTriangle fetchTriangleFrom(samplerBuffer positions, uint id) {
    int first = int(id) * TRIANGLE_POSITION_TEXELS;
    return unpackTriangle(texelFetch(positions, first), texelFetch(positions, first + 1),
                          texelFetch(positions, first + 2), texelFetch(positions, first + 3),
                          texelFetch(positions, first + 4));
}

// The positions alone. Unless `moves`, those of u = 0 stand for both ends: three fetches instead of five.
VertexMotion fetchMotion(samplerBuffer positions, uint id, bool moves) {
    int first = int(id) * TRIANGLE_POSITION_TEXELS;
    vec4 a = texelFetch(positions, first), b = texelFetch(positions, first + 1), c = texelFetch(positions, first + 2);
    if (!moves) return unpackStatic(a, b, c);
    return unpackMotion(a, b, c, texelFetch(positions, first + 3), texelFetch(positions, first + 4));
}

vec3 transformed(mat4 affine, vec3 point) { return (affine * vec4(point, 1.0)).xyz; }

// In view coordinates (ViewBlock), which are linear in u as well.
VertexMotion inView(VertexMotion v, mat4 viewFromWorldOpen, mat4 viewFromWorldClose) {
    return VertexMotion(transformed(viewFromWorldOpen, v.open0), transformed(viewFromWorldOpen, v.open1),
                        transformed(viewFromWorldOpen, v.open2), transformed(viewFromWorldClose, v.close0),
                        transformed(viewFromWorldClose, v.close1), transformed(viewFromWorldClose, v.close2));
}
