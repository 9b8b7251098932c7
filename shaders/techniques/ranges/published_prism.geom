// The prism as published (Hong and Oh 2019, section 4.1): each side in four triangles about the mean of its four
// vertices at t = 0.5, or in two about the point where the edge crosses its moved copy on the screen; then the two
// input triangles. Positions are taken as linear in the map between the ends of the shutter, as that crossing test and
// the later interpolation of NDC depths take them: centres are means of projected vertices.
#include "techniques/ranges/prism.glsl"

layout(points) in;
layout(triangle_strip, max_vertices = 42) out;

in gl_PerVertex { vec4 gl_Position; }
gl_in[];
flat in uint triangleOfPoint[];

out gl_PerVertex { vec4 gl_Position; };
noperspective out float prismTime;
flat out uint prismId;

struct Corner {
    vec4 place;
    float time;
};

void emitVertex(Corner corner) {
    gl_Position = corner.place;
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

vec3 projected(vec4 place) { return place.xyz / place.w; }

// Perp-dot product: the area spanned by two edges.
float pdp(vec2 a, vec2 b) { return a.x * b.y - a.y * b.x; }

// Equation 1. Its AC is A - C.
bool crossing(vec4 p, vec4 q, vec4 movedP, vec4 movedQ, out vec4 place) {
    vec3 a = projected(p), b = projected(q), c = projected(movedP), d = projected(movedQ);
    vec2 ab = b.xy - a.xy, cd = d.xy - c.xy, ac = a.xy - c.xy;
    float area = pdp(ab, cd);
    place = vec4(0.0);
    // "Equal to zero", of numbers that are rounded: an edge that moves along itself has no crossing.
    if (abs(area) <= 1e-5 * length(ab) * length(cd)) return false;
    float s = pdp(cd, ac) / area, u = pdp(ab, ac) / area;
    if (!(s >= 0.0 && s <= 1.0 && u >= 0.0 && u <= 1.0)) return false;
    // Reached at both ends of the shutter. Chosen here, since the paper states neither its time nor its depth: the
    // means.
    place = vec4(0.5 * (mix(a, b, s) + mix(c, d, u)), 1.0);
    return true;
}

void emitSide(vec4 p, vec4 q, vec4 movedP, vec4 movedQ) {
    Corner a = Corner(p, 0.0), b = Corner(q, 0.0), c = Corner(movedQ, 1.0), d = Corner(movedP, 1.0);
    bool inFront = min(min(p.w, q.w), min(movedP.w, movedQ.w)) > 0.0;
    vec4 place;
    if (inFront && crossing(p, q, movedP, movedQ, place)) {
        Corner x = Corner(place, 0.5);
        emit(a, d, x);
        emit(b, c, x);
        return;
    }
    place = inFront ? vec4(0.25 * (projected(p) + projected(q) + projected(movedP) + projected(movedQ)), 1.0)
                    : 0.25 * (p + q + movedP + movedQ);
    Corner centre = Corner(place, 0.5);
    emit(a, b, centre);
    emit(b, c, centre);
    emit(c, d, centre);
    emit(d, a, centre);
}

void main() {
    Prism p = prismOf(triangleOfPoint[0]);
    vec4 open[3], close[3];
    for (int i = 0; i < 3; ++i) {
        open[i] = clipPosition(p.open[i]);
        close[i] = clipPosition(p.close[i]);
    }
    for (int i = 0; i < 3; ++i) {
        int j = i < 2 ? i + 1 : 0;
        emitSide(open[i], open[j], close[i], close[j]);
    }
    emit(Corner(open[0], 0.0), Corner(open[1], 0.0), Corner(open[2], 0.0));
    emit(Corner(close[0], 1.0), Corner(close[1], 1.0), Corner(close[2], 1.0));
}
