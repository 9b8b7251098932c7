// The lists of either form, by one interface: nearerThan, summaryOf.
#include "lib/light_cutouts.glsl"
#include "lib/only_if.glsl"
#include "lib/texel_lists.glsl"
#include "techniques/temporal/bindings.shared.h"
#ifdef AS_PUBLISHED
#include "techniques/temporal/published_lists.glsl"
#else
#include "techniques/temporal/exact_lists.glsl"
#endif
