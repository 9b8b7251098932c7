// The depth that candidates' steps of depth begin at, for those that write the lists and the lookup that reads them.
#include "lib/blocks.glsl"

float leastDepth() {
#ifdef LIGHT_ORTHOGRAPHIC
    return lightView.farDistance / 65536.0;
#else
    return 128.0 * lightView.nearDistance;  // hardly anything is nearer; it counts as of the first step
#endif
}
