// Temporal shadow maps: is a moving triangle between the receiver and the light at the receiver's own time? For each
// tuple of the texel that holds that time, the distance then is interpolated between the tuple's ends (Hong and Oh
// 2017, "Lighting pass").
//
// AS_PUBLISHED: the published form's lists. COVERAGE_MAP: with its coverage map.
#include "lib/lookup.glsl"
#include "techniques/temporal/lists.glsl"

#include "lib/interval_lookup.glsl"
