// The depth that candidates' steps of depth begin at, for the lists' writers and their reader alike.
#include "lib/blocks.glsl"

float leastDepth() {
#ifdef LIGHT_ORTHOGRAPHIC
    return lightView.farDistance / 65536.0;
#else
    return lightView.nearDistance;
#endif
}
