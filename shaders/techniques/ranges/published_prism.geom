// The prism as published (Hong and Oh 2019, section 4.1), made of six vertices in view space: each side in four
// triangles about the mean of its four vertices at t = 0.5, or in two about the point where the edge crosses its moved
// copy on the screen; then the two input triangles. Times are interpolated as a rasteriser does by default, with
// perspective.
#include "techniques/ranges/prism.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 42) out;

in gl_PerVertex { vec4 gl_Position; }
gl_in[];
flat in uint triangleOfPoint[];

out gl_PerVertex { vec4 gl_Position; };
out float prismTime;
flat out uint prismId;

struct Corner {
    vec3 place;  // view coordinates
    float time;
};

void emitVertex(Corner corner) {
    gl_Position = clipPosition(corner.place);
    prismTime = corner.time;
    prismId = triangleOfPoint[0];
    EmitVertex();
}

void emit(Corner a, Corner b, Corner c) {
    emitVertex(a);
    emitVertex(b);
    emitVertex(c);
    EndPrimitive();
}

// The position on the screen, and the factor that makes it homogeneous: both are linear over the screen.
vec3 projected(vec3 place) {
#ifdef LIGHT_ORTHOGRAPHIC
    return vec3(place.xy, place.z);
#else
    return vec3(place.xy, 1.0) / place.z;
#endif
}

vec3 unprojected(vec3 p) {
#ifdef LIGHT_ORTHOGRAPHIC
    return p;
#else
    return vec3(p.xy, 1.0) / p.z;
#endif
}

// Perp-dot product: the area spanned by two edges.
float pdp(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Equation 1. Its AC is A - C.
bool crossing(vec3 p, vec3 q, vec3 movedP, vec3 movedQ, out vec3 place) {
    vec3 a = projected(p), b = projected(q), c = projected(movedP), d = projected(movedQ);
    vec2 ab = b.xy - a.xy, cd = d.xy - c.xy, ac = a.xy - c.xy;
    float area = pdp(ab, cd);
    place = vec3(0.0);
    // "Equal to zero", of numbers that are rounded: an edge that moves along itself has no crossing.
    if (abs(area) <= 1e-5 * length(ab) * length(cd)) return false;
    float s = pdp(cd, ac) / area, u = pdp(ab, ac) / area;
    if (!(s >= 0.0 && s <= 1.0 && u >= 0.0 && u <= 1.0)) return false;
    // Reached at both ends of the shutter, at two points of space. Chosen here, since the paper states neither its time
    // nor its depth: the means.
    place = 0.5 * (unprojected(mix(a, b, s)) + unprojected(mix(c, d, u)));
    return true;
}

void emitSide(vec3 p, vec3 q, vec3 movedP, vec3 movedQ) {
    Corner a = Corner(p, 0.0), b = Corner(q, 0.0), c = Corner(movedQ, 1.0), d = Corner(movedP, 1.0);
    vec3 place;
#ifdef LIGHT_ORTHOGRAPHIC
    bool inFront = true;
#else
    bool inFront = min(min(p.z, q.z), min(movedP.z, movedQ.z)) > 0.0;
#endif
    if (inFront && crossing(p, q, movedP, movedQ, place)) {
        Corner x = Corner(place, 0.5);
        emit(a, d, x);
        emit(b, c, x);
        return;
    }
    Corner centre = Corner(0.25 * (p + q + movedP + movedQ), 0.5);
    emit(a, b, centre);
    emit(b, c, centre);
    emit(c, d, centre);
    emit(d, a, centre);
}

void main() {
    Prism p = prismOf(triangleOfPoint[0]);
    for (int i = 0; i < 3; ++i) {
        int j = i < 2 ? i + 1 : 0;
        emitSide(p.open[i], p.open[j], p.close[i], p.close[j]);
    }
    emit(Corner(p.open[0], 0.0), Corner(p.open[1], 0.0), Corner(p.open[2], 0.0));
    emit(Corner(p.close[0], 1.0), Corner(p.close[1], 1.0), Corner(p.close[2], 1.0));
}
