// The tuples' number or first time, seen from the camera, or their number in the light's map. AS_PUBLISHED: the
// published form's lists.
#include "techniques/temporal/lists.glsl"

#include "lib/list_view.glsl"
