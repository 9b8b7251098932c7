#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

SHARED_BEGIN

/// Exposed radiance to [0, 1]: a rational curve with a toe and a shoulder (Narkowicz 2015, fitted to the ACES reference
/// transforms). Negative input gives 0.
SHARED_FUNCTION float filmicCurve(float radiance) {
    float x = max(radiance, SHARED_FLOAT(0.0)) * SHARED_FLOAT(0.6);
    float y = (x * (SHARED_FLOAT(2.51) * x + SHARED_FLOAT(0.03))) /
              (x * (SHARED_FLOAT(2.43) * x + SHARED_FLOAT(0.59)) + SHARED_FLOAT(0.14));
    return clamp(y, SHARED_FLOAT(0.0), SHARED_FLOAT(1.0));
}

/// The simplest curve that clips nothing (Reinhard and others 2002, equation 3). Negative input gives 0.
SHARED_FUNCTION float reinhardCurve(float radiance) {
    float x = max(radiance, SHARED_FLOAT(0.0));
    return x / (SHARED_FLOAT(1.0) + x);
}

/// Linear [0, 1] to the sRGB encoding of IEC 61966-2-1.
SHARED_FUNCTION float encodeSrgb(float linear) {
    if (linear <= SHARED_FLOAT(0.0031308)) return SHARED_FLOAT(12.92) * linear;
    return SHARED_FLOAT(1.055) * pow(linear, SHARED_FLOAT(1.0) / SHARED_FLOAT(2.4)) - SHARED_FLOAT(0.055);
}

SHARED_END
