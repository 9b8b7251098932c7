// The lists of all texels, with an array per field: collected as fragments, and turned into ranges in place
// (generate.comp).
#include "techniques/ranges/bindings.shared.h"

layout(std430, binding = RANGES_IDS_BINDING) buffer FragmentIds { uint fragmentIds[]; };
layout(std430, binding = RANGES_TIMES_BINDING) buffer FragmentTimes { float fragmentTimes[]; };
layout(std430, binding = RANGES_DISTANCES_BINDING) buffer FragmentDistances { float fragmentDistances[]; };
// Changes per texel, as two halves each: of time, and of distance in texels.
layout(std430, binding = RANGES_SLOPES_BINDING) buffer FragmentSlopes { uvec2 fragmentSlopes[]; };
