// How the light sees a point in its view coordinates (X, Y, Z), Z being the distance along its axis in world units.
// Depths that a map stores are NDC depths from 1 at the near plane (or at the plane of a directional light) downwards,
// so that nearer is greater; under perspective they are near / distance, without a far plane.
#include "lib/blocks.glsl"

// Width of a texel of the shadow map at this distance, world units: of its longer side.
float texelWidth(float distance) {
#ifdef LIGHT_ORTHOGRAPHIC
    return frame.lightCone.w;
#else
    return frame.lightCone.w * distance;
#endif
}

// Outside (near, far) the result lies outside [0, 1].
float ndcDepth(float distance) {
#ifdef LIGHT_ORTHOGRAPHIC
    return 1.0 - distance / lightView.farDistance;
#else
    return lightView.nearDistance / distance;
#endif
}

// The distance that a stored depth stands for; 1e30 where nothing was drawn.
float mapDistance(float stored) {
#ifdef LIGHT_ORTHOGRAPHIC
    return stored > 0.0 ? (1.0 - stored) * lightView.farDistance : 1e30;
#else
    return stored > 0.0 ? lightView.nearDistance / stored : 1e30;
#endif
}

// A vertex seen from the ray through an image position: 0 where it lies on the ray.
vec2 seenFrom(vec2 position, vec3 v) {
#ifdef LIGHT_ORTHOGRAPHIC
    return v.xy - position;
#else
    return v.xy - position * v.z;
#endif
}

// How fast that changes where the vertex moves at the rate `rate`.
vec2 seenRate(vec2 position, vec3 rate) {
#ifdef LIGHT_ORTHOGRAPHIC
    return rate.xy;
#else
    return rate.xy - position * rate.z;
#endif
}
