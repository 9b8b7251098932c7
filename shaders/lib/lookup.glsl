// What every technique's lookup comes down to: one answer a camera sample. The technique's file includes this one, says
//     float litOf(MovingTriangle t, Receiver r)
// for a receiver that faces the light and lies inside its cone, and includes lib/lookup_main.glsl last.
// STATIC_CASTERS_ONLY: what moves is left out of the question.
#include "lib/light_map.glsl"

layout(location = 0) uniform uint stratum;
