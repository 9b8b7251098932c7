// What the lookup and the views know of the lists.
#include "techniques/temporal/receiver_texel.glsl"
#ifdef AS_PUBLISHED
#include "techniques/temporal/published_lists.glsl"
#else
#include "techniques/temporal/exact_lists.glsl"
#endif
