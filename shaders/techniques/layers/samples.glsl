// The samples of the time-dependent map that the layers are made of.
#include "techniques/layers/tile.glsl"

uniform sampler2DArray sampleDepth;   // as the map stores it
uniform sampler2DArray sampleMotion;  // rate of the point seen, in the light's view coordinates; time, also of nothing

const int BLOCK = 4;  // texels; tiles and windows are made of whole blocks

struct MapSample {
    bool empty;
    float depth;     // world units
    vec3 rate;       // in the light's view coordinates
    float toMiddle;  // time from the sample's to the middle of the shutter
};

bool isEmpty(ivec3 place) { return texelFetch(sampleDepth, place, 0).x <= 0.0; }

MapSample sampleAt(ivec3 place) {
    MapSample s;
    float stored = texelFetch(sampleDepth, place, 0).x;
    s.empty = stored <= 0.0;
    s.depth = mapDistance(stored);
    vec4 motion = texelFetch(sampleMotion, place, 0);
    s.rate = motion.xyz;
    s.toMiddle = 0.5 - motion.w;
    return s;
}

float depthAtMiddle(MapSample s) { return s.depth + s.rate.z * s.toMiddle; }

// Of the point seen, were it at this map position (in texels) and at that depth.
vec2 motionInMap(MapSample s, vec2 position, float depth) {
#ifdef LIGHT_ORTHOGRAPHIC
    return s.rate.xy * lightView.size;
#else
    return (s.rate.xy * lightView.size - position * s.rate.z) / depth;
#endif
}
