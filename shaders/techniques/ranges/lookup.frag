// Depth-time ranges: is a moving triangle between the receiver and the light at the receiver's own time? For each range
// of the texel that holds that time, the distance then is interpolated between the range's ends (Hong and Oh 2019,
// section 3.3).
//
// AS_PUBLISHED: the published form's lists.
#include "lib/lookup.glsl"
#include "techniques/ranges/lists.glsl"

#include "lib/interval_lookup.glsl"
