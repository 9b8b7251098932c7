// The strata of a map over time, one layer each.
//
// OWN_STRATA: they are not those of the camera samples.
#include "lib/blocks.glsl"

uniform uint layers;
uniform float layerLength;  // u

// The layer that a camera sample of the stratum `ofSample` at time u is tested in.
uint layerAt(float u, uint ofSample) {
#ifdef OWN_STRATA
    return layerLength > 0.0 ? uint(clamp((u - frame.timeBase) / layerLength, 0.0, float(layers - 1u))) : 0u;
#else
    return ofSample;
#endif
}
