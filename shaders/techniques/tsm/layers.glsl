// The layers of a time-dependent shadow map, one a stratum of the shutter, and the one map of what is static in the
// light's space.
//
// OWN_STRATA: the map's strata are not those of the camera samples.
#include "lib/lookup.glsl"

uniform sampler2DArray depthMap;
uniform sampler2DArray staticMap;
uniform uint layers;
uniform float layerLength;  // u

uint layerOf(float u) {
#ifdef OWN_STRATA
    return layerLength > 0.0 ? uint(clamp((u - frame.timeBase) / layerLength, 0.0, float(layers - 1u))) : 0u;
#else
    return stratum;
#endif
}
