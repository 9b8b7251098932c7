// Width of a texel of the light's map at this distance along the light's axis, world units.
#include "lib/blocks.glsl"

float texelWidth(float distance) {
#ifdef LIGHT_ORTHOGRAPHIC
    return frame.lightCone.w;
#else
    return frame.lightCone.w * distance;
#endif
}
