// Linear radiance to what a screen shows. TONE_MAP: 0 shows the values as they are (visibility), 1 is filmic.
layout(binding = 0) uniform sampler2D radiance;
layout(location = 0) uniform float scale;  // 1 / the part of the renders that has been added up so far

layout(location = 0) out vec4 outputColor;

// A rational curve with a toe and a shoulder (Narkowicz 2015, fitted to the ACES reference transforms).
vec3 filmic(vec3 x) {
    x *= 0.6;
    return clamp((x * (2.51 * x + 0.03)) / (x * (2.43 * x + 0.59) + 0.14), 0.0, 1.0);
}

// IEC 61966-2-1.
vec3 encodeSrgb(vec3 x) {
    return mix(12.92 * x, 1.055 * pow(max(x, vec3(1e-9)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, x));
}

void main() {
    vec3 color = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb * scale;
#if TONE_MAP
    color = filmic(color);
#else
    color = clamp(color, 0.0, 1.0);
#endif
    outputColor = vec4(encodeSrgb(color), 1.0);
}
