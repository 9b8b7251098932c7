// The moving triangle of a cover, and how the centre of this texel sees it.
#include "lib/light_projection.glsl"
#include "shared/coverage_intervals.shared.h"

flat in vec3 open0;
flat in vec3 open1;
flat in vec3 open2;
flat in vec3 close0;
flat in vec3 close1;
flat in vec3 close2;
flat in uint triangleId;
flat in uint nonTranslating;

vec2 texelCentre() { return gl_FragCoord.xy / lightView.size; }

struct SeenTriangle {
    vec2 open0, open1, open2, close0, close1, close2;
};

SeenTriangle seenTriangle(vec2 position) {
    return SeenTriangle(seenFrom(position, open0), seenFrom(position, open1), seenFrom(position, open2),
                        seenFrom(position, close0), seenFrom(position, close1), seenFrom(position, close2));
}

EdgeQuadratics quadraticsOf(SeenTriangle t) {
    return edgeQuadratics(t.open0, t.open1, t.open2, t.close0, t.close1, t.close2);
}

float casterDistance(SeenTriangle t, float u) {
    return distanceAt(mix(t.open0, t.close0, u), mix(t.open1, t.close1, u), mix(t.open2, t.close2, u),
                      mix(vec3(open0.z, open1.z, open2.z), vec3(close0.z, close1.z, close2.z), u));
}
