// A rectangle of the light's map plane around all that a moving triangle covers, from the opening of the last frame's
// shutter to the closing of this one's, at its least distance from the light. One texel wider than need be.
#include "techniques/history/blocks.glsl"

uniform samplerBuffer previousPositions;
layout(binding = LARGE_TRIANGLES_UNIT) uniform usamplerBuffer dynamicCasters;

out gl_PerVertex { vec4 gl_Position; };

void include(vec3 world, inout vec3 low, inout vec2 high) {
    vec3 v = (lightView.viewFromWorldOpen * vec4(world, 1.0)).xyz;
#ifndef LIGHT_ORTHOGRAPHIC
    bool behind = v.z <= lightView.nearDistance;
    v = behind ? vec3(0.0, 0.0, lightView.nearDistance) : vec3(v.xy / v.z, v.z);
    if (behind) high = vec2(1.0);  // and its low corner is the map's
#endif
    low = min(low, v);
    high = max(high, v.xy);
}

void main() {
    int first = int(texelFetch(dynamicCasters, gl_InstanceID).x) * TRIANGLE_POSITION_TEXELS;
    vec3 low = vec3(1e30);
    vec2 high = vec2(-1e30);
    for (int frameNumber = 0; frameNumber < 2; ++frameNumber) {
        vec4 texels[TRIANGLE_POSITION_TEXELS];
        for (int i = 0; i < TRIANGLE_POSITION_TEXELS; ++i)
            texels[i] = frameNumber == 0 ? texelFetch(previousPositions, first + i) : texelFetch(trianglePositions, first + i);
        include(texels[0].xyz, low, high);
        include(vec3(texels[0].w, texels[1].xy), low, high);
        include(vec3(texels[1].zw, texels[2].x), low, high);
        include(texels[2].yzw, low, high);
        include(texels[3].xyz, low, high);
        include(vec3(texels[3].w, texels[4].xy), low, high);
    }
    vec2 margin = vec2(1.5 / history.dynamicMaskSize);
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? low.x - margin.x : high.x + margin.x, (gl_VertexID & 2) == 0 ? low.y - margin.y : high.y + margin.y);
#ifdef LIGHT_ORTHOGRAPHIC
    float stored = 1.0 - low.z / lightView.farDistance;
#else
    float stored = lightView.nearDistance / max(low.z, lightView.nearDistance);
#endif
    gl_Position = vec4(2.0 * corner - 1.0, clamp(stored, 0.0, 1.0), 1.0);
}
