// The layers of a time-dependent shadow map, one a stratum of the shutter, and the one map of what is static in the
// light's space.
#include "lib/lookup.glsl"
#include "lib/map_strata.glsl"

uniform sampler2DArray depthMap;
uniform sampler2DArray staticMap;
