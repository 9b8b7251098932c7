// The lists of all texels, a field an array: collected as fragments, and turned into ranges where they lie (generate.comp).
#include "techniques/ranges/bindings.shared.h"

layout(std430, binding = RANGES_IDS_BINDING) buffer FragmentIds { uint fragmentIds[]; };
layout(std430, binding = RANGES_TIMES_BINDING) buffer FragmentTimes { float fragmentTimes[]; };
layout(std430, binding = RANGES_DISTANCES_BINDING) buffer FragmentDistances { float fragmentDistances[]; };
layout(std430, binding = RANGES_SLOPES_BINDING) buffer FragmentSlopes { uvec2 fragmentSlopes[]; };  // changes per texel, two halves each: of time, of distance in texels
