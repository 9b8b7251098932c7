// The ranges' number or first time, seen from the camera. AS_PUBLISHED: the published form's lists.
#include "techniques/ranges/lists.glsl"

#include "lib/list_view.glsl"
