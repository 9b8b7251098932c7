// Where a surface point lies for this frame's camera, and for the camera one frame ago.
#include "lib/receiver.glsl"
#include "techniques/history/blocks.glsl"

mat3 previousRays(float u) { return mat3(history.previousRaysOpen) * (1.0 - u) + mat3(history.previousRaysClose) * u; }
vec3 previousEye(float u) { return mix(history.previousEyeOpen.xyz, history.previousEyeClose.xyz, u); }

// Rounding must not make a static camera read neighbouring texels. `pixel`: texel centres at whole numbers.
vec2 roundedToTexel(vec2 pixel) {
    vec2 nearest = floor(pixel + 0.5);
    return all(lessThan(abs(pixel - nearest), vec2(1e-3))) ? nearest : pixel;
}

// Distance along the ray of its image position, as the camera measures it at the receiver's time.
float distanceOf(Receiver r, vec2 position) {
    float distance = inCameraAt(r.position, r.position, r.time).z;
#ifdef CAMERA_TURNS
    return distance / cameraRayAt(position, r.time).z;
#else
    return distance;
#endif
}
