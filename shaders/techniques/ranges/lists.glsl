// The lists of either form, by one interface: nearerThan, summaryOf.
#include "lib/light_cutouts.glsl"
#include "lib/texel_lists.glsl"
#include "techniques/ranges/bindings.shared.h"
#ifdef AS_PUBLISHED
#include "techniques/ranges/linked_lists.glsl"
#else
#include "techniques/ranges/contiguous_lists.glsl"
#endif
