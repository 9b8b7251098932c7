// One value per pixel as a colour; neutral grey where it is negative.
#include "shared/heat_color.shared.h"

uniform sampler2D values;
uniform vec3 scale;  // its ends, and whether it is logarithmic

layout(location = 0) out vec4 outputColor;

void main() {
    float value = texelFetch(values, ivec2(gl_FragCoord.xy), 0).r;
    vec3 color = value < 0.0 ? heatNothing() : heatColor(heatShare(value, scale.x, scale.y, scale.z != 0.0));
    outputColor = vec4(color, 1.0);
}
