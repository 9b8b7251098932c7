// Linear radiance to what a screen shows. TONE_MAP: 0 shows the values as they are, 1 is filmic, 2
// Reinhard's.
#include "shared/display_curve.shared.h"

uniform sampler2D radiance;
uniform float scale;  // 1 / the part of the renders that has been added up so far, times the exposure

layout(location = 0) out vec4 outputColor;

void main() {
    vec3 color = texelFetch(radiance, ivec2(gl_FragCoord.xy), 0).rgb * scale;
#if TONE_MAP == 1
    color = vec3(filmicCurve(color.r), filmicCurve(color.g), filmicCurve(color.b));
#elif TONE_MAP == 2
    color = vec3(reinhardCurve(color.r), reinhardCurve(color.g), reinhardCurve(color.b));
#else
    color = clamp(color, 0.0, 1.0);
#endif
    outputColor = vec4(encodeSrgb(color.r), encodeSrgb(color.g), encodeSrgb(color.b), 1.0);
}
