// The same along a line from the light: for maps that hold a triangle's number and when it is there.
#include "lib/cutouts.glsl"
#include "lib/light_projection.glsl"
#include "lib/triangle_texels.glsl"
#include "shared/moving_triangle.shared.h"

#ifdef CUTOUTS
// Does the triangle cover where the line through a place of the map meets its plane at time u? Beside the triangle, as
// a place may lie that is not a texel's centre, the nearest of its edges counts.
bool cutoutCoversLight(uint id, vec2 place, float u) {
    bool covers = true;
    if (isCutOut(id)) {
        VertexMotion v = inView(fetchMotion(positionsOfCutouts, id, true), lightView.viewFromWorldOpen,
                                lightView.viewFromWorldClose);
        vec3 e = edgeFunctions(seenFrom(place, mix(v.open0, v.close0, u)), seenFrom(place, mix(v.open1, v.close1, u)),
                               seenFrom(place, mix(v.open2, v.close2, u)));
        e = e.x + e.y + e.z < 0.0 ? min(e, vec3(0.0)) : max(e, vec3(0.0));
        covers = cutoutCovers(id, e.x + e.y + e.z != 0.0 ? e : vec3(1.0));
    }
    return covers;
}
#else
bool cutoutCoversLight(uint id, vec2 place, float u) { return true; }
#endif
