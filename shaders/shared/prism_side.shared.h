#ifdef __cplusplus
#pragma once
#endif
#include "shared/types.shared.h"

// The side of a prism is what an edge sweeps: from a..b at u = 0 to c..d at u = 1. Its points are
//     P(s, u) = a + s (b - a) + u (c - a) + s u T,   s: place on the edge, 0 at a and 1 at b,   T = (a - b) - (c - d):
//     the twist.
// It is drawn as a fan of four flat triangles about its centre, over which s and u are interpolated.

SHARED_BEGIN

/// How much of the twist the bilinear side has at (s, u) beyond what the fan has there: P(s, u) = F(s, u) +
/// beyondFan(s, u) T. 0 at the corners, on the edges and in the centre, at most 1/16 in size. Valid for s and u in [0,
/// 1]. Error: at most 2^-24. Source: derived here (x y, less its interpolation over the fan, in coordinates from the
/// centre).
SHARED_FUNCTION float beyondFan(float s, float u) {
    float x = s - SHARED_FLOAT(0.5), y = u - SHARED_FLOAT(0.5);
    float least = SHARED_FLOAT(0.5) * min(abs(x), abs(y));
    return x * y - ((x < SHARED_FLOAT(0.0)) == (y < SHARED_FLOAT(0.0)) ? least : -least);
}

/// Of a step from a texel's centre to any point of the texel, the share in which the edge itself can pass that point: 1
/// where it is long enough. Beyond its ends it is the line through it that passes, and of an edge that slides along
/// itself that line is there for much longer. Slopes are changes per texel, of the time at which the edge passes and of
/// the place on it that does. A step is one along the slope of the place, which ends where the edge ends, and one
/// across it, on which the place stays and which is half the texel's diagonal at the most: together they bound the
/// time. The step is short enough when its time is. Valid for slopes that are 0 or of a size from 1e-9 to 1e9 and for 0
/// <= place <= 1; an edge of more than a million texels has no ends here. Error: at most 2^-20 of the share. Source:
/// derived here.
SHARED_FUNCTION float stepWithinEdge(vec2 timeSlope, vec2 placeSlope, float place) {
    float overTexel = SHARED_FLOAT(0.5) * (abs(timeSlope.x) + abs(timeSlope.y)), steepness = length(placeSlope);
    if (!(steepness > SHARED_FLOAT(1e-6))) return SHARED_FLOAT(1.0);
    vec2 direction = placeSlope / steepness;
    float toEnd = max(place, SHARED_FLOAT(1.0) - place) / steepness;
    float alongPlaces = toEnd * abs(timeSlope.x * direction.x + timeSlope.y * direction.y);
    float atOnePlace = SHARED_FLOAT(0.70710678) * abs(timeSlope.x * direction.y - timeSlope.y * direction.x);
    float most = alongPlaces + atOnePlace;
    return most < overTexel ? most / overTexel : SHARED_FLOAT(1.0);
}

SHARED_END
