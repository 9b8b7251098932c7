// The lists of either form, by one interface: nearerThan, summaryOf.
#include "techniques/ranges/receiver_texel.glsl"
#ifdef AS_PUBLISHED
#include "techniques/ranges/linked_lists.glsl"
#else
#include "techniques/ranges/contiguous_lists.glsl"
#endif
