// The intervals' number or first time, or the error of their compression, seen from the camera, or their number in the
// light's map.
//
// VIEW_ERROR: the error. AS_PUBLISHED: there is one.
#include "techniques/intervals/lists.glsl"

#ifdef VIEW_ERROR
uniform samplerBuffer intervalErrors;
layout(location = 0) out float outputValue;

void main() {
    uvec2 pixel = uvec2(gl_FragCoord.xy);
    float sum = 0.0, count = 0.0;
    for (uint stratum = 0u; stratum < frame.strata; ++stratum) {
        uint id = texelFetch(sampleIds, ivec3(pixel, stratum), 0).x;
        if (id == NO_TRIANGLE) continue;
        Receiver r = receiverOf(fetchTriangle(id), id, pixel, stratum);
        ivec2 texel;
        if (!texelOf(mapPointOf(r, r.time), texel)) continue;
        sum += texelFetch(intervalErrors, listNumber(texel)).x;
        count += 1.0;
    }
    outputValue = count > 0.0 ? sum / count : -1.0;
}
#else
#include "lib/list_view.glsl"
#endif
