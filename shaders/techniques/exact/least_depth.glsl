// The depth that candidates' steps of depth begin at, for those that write the lists and the lookup that reads them.
#include "lib/blocks.glsl"

float leastDepth() {
#ifdef LIGHT_ORTHOGRAPHIC
    return lightView.farDistance / 65536.0;
#else
    return lightView.nearDistance;
#endif
}
