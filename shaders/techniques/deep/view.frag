// How many nodes the visibility function has, seen from the camera or in the light's map.
#include "lib/receiver.glsl"
#include "techniques/deep/nodes.glsl"

#include "lib/list_view.glsl"
