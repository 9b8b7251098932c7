// The tuples' number or first time, seen from the camera. AS_PUBLISHED: the published form's lists.
#include "techniques/temporal/lists.glsl"

#include "lib/list_view.glsl"
