// Diagnostics of the history per pixel. view: 0 this frame's mean confidence, 1 frames in the history, 2 whether a past
// was looked for and rejected.
#include "techniques/history/map_test.glsl"
#include "techniques/history/texel.glsl"

uniform sampler2D written;
uniform uint view;

layout(location = 0) out float outputValue;

float meanConfidence(uvec2 pixel) {
    float sum = 0.0, tested = 0.0;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
        if (id == NO_TRIANGLE) continue;
        MovingTriangle t = fetchTriangle(id);
        Receiver r = receiverOf(t, id, pixel, stratum);
        if (!facesLight(r)) continue;
        sum += testShadow(pointAt(t, id, r.barycentrics, history.instant), history.instant).confidence;
        tested += 1.0;
    }
    return sum / max(tested, 1.0);
}

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    vec4 h = texelFetch(written, ivec2(pixel), 0);
    float age = setting.as_published ? h.z : ageOf(h);
    outputValue = -1.0;
    if (h.y <= 0.0) return;
    if (view == 0u) outputValue = meanConfidence(pixel);
    if (view == 1u) outputValue = age;
    if (view == 2u) outputValue = history.hasPast != 0u && age == 1.0 ? 1.0 : 0.0;
}
