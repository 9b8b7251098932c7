// The coverage map of the repaired form: how far away, at the most, the nearest triangle ever is that covers the texel's centre all
// through the shutter. Far beyond everything where there is none. Whatever lies behind it changes nothing: a receiver behind is in
// that triangle's shadow, and a receiver in front (the triangle itself, all over the texel) cannot be shadowed from behind.
uniform sampler2DArray coverageMap;

float coverageDistance(ivec2 texel) {
    float stored = texelFetch(coverageMap, ivec3(texel, 0), 0).x;
#ifdef LIGHT_ORTHOGRAPHIC
    return stored > 0.0 ? (1.0 - stored) * lightView.farDistance : 1e30;
#else
    return stored > 0.0 ? lightView.nearDistance / stored : 1e30;
#endif
}
