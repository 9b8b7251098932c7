#ifdef __cplusplus
#pragma once
#endif
#include "shared/display_curve.shared.h"
#include "shared/types.shared.h"

SHARED_BEGIN

/// OKLab (Ottosson 2020), given by lightness, chroma and hue in radians, to encoded sRGB; clipped to what that can
/// show.
SHARED_FUNCTION vec3 srgbOfOklab(float lightness, float chroma, float hue) {
    float a = chroma * cos(hue), b = chroma * sin(hue);
    float l = lightness + SHARED_FLOAT(0.3963377774) * a + SHARED_FLOAT(0.2158037573) * b;
    float m = lightness - SHARED_FLOAT(0.1055613458) * a - SHARED_FLOAT(0.0638541728) * b;
    float s = lightness - SHARED_FLOAT(0.0894841775) * a - SHARED_FLOAT(1.2914855480) * b;
    l = l * l * l;
    m = m * m * m;
    s = s * s * s;
    vec3 linear =
        clamp(vec3(SHARED_FLOAT(4.0767416621) * l - SHARED_FLOAT(3.3077115913) * m + SHARED_FLOAT(0.2309699292) * s,
                   SHARED_FLOAT(-1.2684380046) * l + SHARED_FLOAT(2.6097574011) * m - SHARED_FLOAT(0.3413193965) * s,
                   SHARED_FLOAT(-0.0041960863) * l - SHARED_FLOAT(0.7034186147) * m + SHARED_FLOAT(1.7076147010) * s),
              SHARED_FLOAT(0.0), SHARED_FLOAT(1.0));
    return vec3(encodeSrgb(linear.x), encodeSrgb(linear.y), encodeSrgb(linear.z));
}

/// The colour of a share in [0, 1] of a heat map's scale, encoded: lightness grows evenly, from deep blue by way of
/// magenta and orange to pale yellow. The deepest is still lighter and more colourful than heatNothing.
SHARED_FUNCTION vec3 heatColor(float share) {
    float t = clamp(share, SHARED_FLOAT(0.0), SHARED_FLOAT(1.0));
    float chroma = SHARED_FLOAT(0.165) * sin(SHARED_FLOAT(3.14159265) * (SHARED_FLOAT(0.22) + SHARED_FLOAT(0.60) * t));
    return srgbOfOklab(SHARED_FLOAT(0.32) + SHARED_FLOAT(0.64) * t, chroma,
                       SHARED_FLOAT(4.75) + SHARED_FLOAT(3.25) * t);
}

/// Where there is nothing to show: a neutral dark grey.
SHARED_FUNCTION vec3 heatNothing() { return vec3(SHARED_FLOAT(0.10)); }

/// Where a value lies on a scale, 0 to 1 between its ends. low < high; logarithmic: 0 < low.
SHARED_FUNCTION float heatShare(float value, float low, float high, bool logarithmic) {
    if (logarithmic) return log(max(value, low) / low) / log(high / low);
    return (value - low) / (high - low);
}

SHARED_END
