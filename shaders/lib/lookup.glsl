// The common frame of every technique's lookup, which computes the visibility of the light from one receiver. The
// technique's file includes this one, defines one of
//     float litOf(MovingTriangle t, Receiver r)
//         at the receiver's own time (Footprint: Instant)
//     float litOver(MovingTriangle t, Receiver r, float u0, float u1)
//         the mean over [u0, u1] of the shutter, the receiver followed as a point of its triangle. Weighted by the
//         shutter's response: the integral of w lit over that of w, from u0 to u1, with w = shutterWeight(
//         frame.response, frame.responseWidth, u) of shared/shutter_response.shared.h; an interval [a, b] of light adds
//         shutterExposure(.., b) - shutterExposure(.., a). Where u0 = u1 it is litOf there.
// for a receiver that faces the light and lies inside its cone, and includes lib/lookup_main.glsl last.
//
// A technique that solves intervals (Technique::solvesIntervals) also defines
//     vec4 litAlong(MovingTriangle t, uint id, vec2 position, float u0, float u1)
//         the same for what the ray of an image position sees of the triangle, all through [u0, u1]. x: the mean over
//         the times at which the receiver faces the light inside its cone; y: their share of the exposure; z, w: of the
//         times at which it is lit, from 0 at u0 to 1 at u1, the mean and the mean of the squares.
//
// INTERVAL_SAMPLES: values are those of parts (lib/seen_parts.glsl). SOLVES_INTERVALS: of all of a part.
// STATIC_CASTERS_ONLY: dynamic casters are left out.
#include "lib/light_map.glsl"
#include "lib/settings.glsl"

#ifdef INTERVAL_SAMPLES
#include "lib/seen_parts.glsl"
uint stratum;  // of the part
uvec2 samplePixel;
#else
uniform uint stratum;
#define samplePixel uvec2(gl_FragCoord.xy)
#endif
