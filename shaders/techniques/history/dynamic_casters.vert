// A rectangle of the light's image plane around all that a moving triangle covers, from the opening of the last frame's
// shutter to the closing of this one's, at its least distance from the light. One texel wider than the bounds.
#include "techniques/history/blocks.glsl"

uniform samplerBuffer previousPositions;
layout(binding = LARGE_TRIANGLES_UNIT) uniform usamplerBuffer dynamicCasters;

out gl_PerVertex { vec4 gl_Position; };

void include(vec3 world, inout vec3 low, inout vec2 high) {
    vec3 v = transformed(lightView.viewFromWorldOpen, world);
#ifndef LIGHT_ORTHOGRAPHIC
    bool behind = v.z <= lightView.nearDistance;
    v = behind ? vec3(0.0, 0.0, lightView.nearDistance) : vec3(v.xy / v.z, v.z);
    if (behind) high = vec2(1.0);  // and its low corner is the map's
#endif
    low = min(low, v);
    high = max(high, v.xy);
}

void includeTriangle(VertexMotion v, inout vec3 low, inout vec2 high) {
    include(v.open0, low, high);
    include(v.open1, low, high);
    include(v.open2, low, high);
    include(v.close0, low, high);
    include(v.close1, low, high);
    include(v.close2, low, high);
}

void main() {
    uint id = texelFetch(dynamicCasters, gl_InstanceID).x;
    vec3 low = vec3(1e30);
    vec2 high = vec2(-1e30);
    includeTriangle(fetchMotion(previousPositions, id, true), low, high);
    includeTriangle(fetchMotion(trianglePositions, id, true), low, high);
    vec2 margin = vec2(1.5 / history.dynamicMaskSize);
    vec2 corner = vec2((gl_VertexID & 1) == 0 ? low.x - margin.x : high.x + margin.x,
                       (gl_VertexID & 2) == 0 ? low.y - margin.y : high.y + margin.y);
#ifdef LIGHT_ORTHOGRAPHIC
    float stored = ndcDepth(low.z);
#else
    float stored = ndcDepth(max(low.z, lightView.nearDistance));
#endif
    gl_Position = vec4(2.0 * corner - 1.0, clamp(stored, 0.0, 1.0), 1.0);
}
