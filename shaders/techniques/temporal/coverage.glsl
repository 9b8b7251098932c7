// The coverage map of the repaired form: the greatest distance, during the shutter, of the nearest triangle that covers
// the texel's centre all through the shutter. 1e30 where there is none. Whatever lies behind it changes nothing: a
// receiver behind is in that triangle's shadow, and a receiver in front (the triangle itself, all over the texel)
// cannot be shadowed from behind.
#include "lib/light_projection.glsl"

uniform sampler2DArray coverageMap;

float coverageDistance(ivec2 texel) { return mapDistance(texelFetch(coverageMap, ivec3(texel, 0), 0).x); }
